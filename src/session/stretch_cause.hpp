#pragma once

#include "scene/scene.hpp"
#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"

#include <optional>

namespace drape {

/// Why springs are stretched beyond anything that cloth does.
enum class StretchCause {
  Slivers,     ///< only springs that are far shorter than the others
  Unit,        ///< the cloth is so large, and so heavy, that its file is probably in another unit
  Heavy,       ///< a square metre weighs more than any fabric
  Soft,        ///< the springs do not carry the weight
  Attachment,  ///< the mouse pulls
  TimeStep,    ///< the solver's steps are longer than it stays stable with
  Solver,      ///< none of these: the solver failed
};

/// What was found about overstretched springs.
struct StretchDiagnosis {
  StretchCause cause = StretchCause::Solver;
  Advice advice;  ///< in words, and the change that would help
};

/// Springs that are longer than this times their rest length, less one, are overstretched [-].
inline constexpr double implausibleStretch = 2.0;

/// Finds out why springs of a state are overstretched. Call it when some are.
/// @param pulled whether the mouse pulls at the cloth
[[nodiscard]] StretchDiagnosis diagnoseStretch(const Scene& scene, const Settings& settings, const ClothModel& model,
                                               const ClothState& state, bool pulled);

}  // namespace drape
