#pragma once

#include "sim/adaptive/sleep_detection.hpp"
#include "sim/adaptive/step_memory.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

#include <vector>

namespace drape::sim::adaptive {

/// Slows cloth in contact that hardly moves any more, so that it comes to rest and can sleep.
///
/// Friction between yarns stops a real garment within seconds. The linear damping of fabrics does not: a hem continues
/// to swing, and changes of contacts excite the cloth again. So cloth in contact loses velocity with the time constant
/// tuning.settlingTime, once its mean displacement in each of the last tuning.settlingIntervals intervals was below the
/// error tolerance, and no vertex moved much further. The mean position error that this causes is below the tolerance
/// too. Only cloth that could sleep settles: no body moves, and no attachment acts.
///
/// Whether settling cloth sleeps depends on its mean displacement (SleepDetection). So a few vertices that creep do not
/// keep it awake.
///
/// Call it before a step. Updates `memory`.
/// @return the change of the kinetic energy, at most 0 [J]
double settle(const ClothModel& model, const SleepConditions& conditions, StepMemory& memory, ClothState& state);

/// Whether the cloth settles.
[[nodiscard]] bool isSettling(const StepMemory& memory);

/// Whether the mean displacement is below a distance [m], and no displacement exceeds a multiple of it.
[[nodiscard]] bool hardlyMoved(const std::vector<Vec3>& before, const std::vector<Vec3>& positions, double distance);

}  // namespace drape::sim::adaptive
