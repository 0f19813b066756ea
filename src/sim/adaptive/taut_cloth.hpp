#pragma once

#include "sim/adaptive/coarse_levels.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_model.hpp"

#include <vector>

namespace drape::sim::adaptive {

/// Whether pins hold a cloth taut: no force as large as its weight can move it far, as with a sheet at its four corners
/// or between two edges. A sheet that hangs from two corners is not taut, because a force to the side moves it.
///
/// The test relaxes a coarse level of the cloth under its weight in four directions, by dynamic relaxation with kinetic
/// damping (Day 1965; Barnes 1999). The cloth is taut if the aggregates move by less than a fraction of the cloth's
/// diagonal on average (AutoTuning::tautReach). It takes up to about a millisecond.
/// @param levels of the cloth  @param positions of its vertices [m]
[[nodiscard]] bool isTaut(const ClothModel& model, const std::vector<CoarseLevel>& levels,
                          const CommonParameters& parameters, const std::vector<Vec3>& positions);

}  // namespace drape::sim::adaptive
