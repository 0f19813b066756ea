#pragma once

#include "sim/adaptive/step_memory.hpp"
#include "sim/contact/contact_parameters.hpp"
#include "sim/contact/contact_stage.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/forces/step_inputs.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/model_cache.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace drape::sim::adaptive {

/// Everything, apart from the model and the state, that decides whether a cloth sleeps. It holds references and must
/// not outlive what they refer to.
struct SleepConditions {
  const CommonParameters& parameters;
  const contact::ContactParameters& contact;
  const StepInputs& inputs;
  double errorTolerance = 0.0;  ///< AutoOptions::errorTolerance [m]
};

/// Whether cloth could come to rest: it loses energy, no body moves, and no attachment acts.
[[nodiscard]] bool isUndisturbed(const SleepConditions& conditions);

/// Detects cloth at rest and puts it to sleep until something changes.
///
/// Cloth sleeps when for one second no vertex moved further than a tenth of the error tolerance or a thousandth of the
/// mean edge length. Of cloth that settles (adaptive::settle) the mean displacement counts, which must stay below
/// tuning.settledToleranceFraction of the error tolerance. Damping or drag must act,
/// there must be no attachment, and pins or bodies must support every piece: a piece without pins must lie on a body in
/// the direction of its weight and the air's force. Cloth in wind whose pieces all have pins must also stay in place
/// for one more second after a disturbance that is too small to be seen: a sheet in line with the wind is in an
/// unstable equilibrium, in which only rounding would move it. The velocities of sleeping cloth are set to zero. It
/// sleeps as long as its state and everything that acts on it (settings, pins, masses, bodies) are bitwise the same.
class SleepDetection {
 public:
  /// Whether the cloth sleeps, so that the step has nothing to do. Updates `memory`.
  [[nodiscard]] bool isAsleep(const ClothModel& model, const SleepConditions& conditions, StepMemory& memory,
                              ClothState& state);

  /// Whether the cloth slept in the last step and nothing has changed since.
  [[nodiscard]] bool staysAsleep(const ClothModel& model, const SleepConditions& conditions, const StepMemory& memory,
                                 const ClothState& state);

 private:
  /// Data of a model, computed once.
  struct ModelData {
    std::vector<std::vector<std::size_t>> freePieces;  // pieces without pins
    double meanEdge = 0.0;                             // [m]
    std::uint64_t fingerprint = 0;                     // of masses, pins, springs and the fabric
  };

  [[nodiscard]] static ModelData dataOf(const ClothModel& model);
  [[nodiscard]] static bool canSleep(const ModelData& data, const SleepConditions& conditions);
  [[nodiscard]] bool isSupported(const ClothModel& model, const ModelData& data, const SleepConditions& conditions,
                                 const ClothState& state);
  [[nodiscard]] static std::uint64_t fingerprintOf(const ModelData& data, const SleepConditions& conditions);

  ModelCache<ModelData> models_;
  contact::ContactStage contact_;  // of the trial that tests for support
};

}  // namespace drape::sim::adaptive
