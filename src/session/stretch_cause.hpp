#pragma once

#include "scene/scene.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

namespace drape::session {

/// Causes of implausibly stretched edges.
enum class StretchCause {
  Pattern,     ///< the rest shape is a pattern that does not fit the mesh
  Slivers,     ///< only edges that are far shorter than the others
  Unit,        ///< the cloth is so large and heavy that its file probably uses another unit
  Heavy,       ///< heavier per square metre than any fabric
  Soft,        ///< the springs or the fabric are too soft for the weight
  Attachment,  ///< the mouse or pins pull
  External,    ///< bodies or the weight hold the cloth, which hardly moves
  TimeStep,    ///< the step is longer than the solver's stability limit
  Solver,      ///< none of these: the solver failed
};

/// The cause of overstretched edges, with advice.
struct StretchDiagnosis {
  StretchCause cause = StretchCause::Solver;
  scene::Advice advice;  ///< in words, with the setting that helps
};

/// An edge is overstretched when its strain exceeds this [-].
inline constexpr double implausibleStretch = 2.0;

/// Finds the cause of overstretched edges in a state. Call it only when there are some.
/// @param pulled whether the mouse pulls at the cloth
[[nodiscard]] StretchDiagnosis diagnoseStretch(const scene::Scene& scene, const settings::Settings& settings,
                                               const sim::ClothModel& model, const sim::ClothState& state, bool pulled);

}  // namespace drape::session
