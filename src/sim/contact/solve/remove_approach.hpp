#pragma once

#include "sim/model/cloth_state.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace drape::sim::contact {

/// Removes the velocity of moved vertices towards the obstacle that moved them. The normal of the obstacle is the
/// direction of the displacement.
/// @param before positions of the vertices before they were moved to those of `state` [m]
/// @param obstacleVelocity velocity of the obstacle that moved a vertex [m/s]
/// @param spread a velocity changes by at most the displacement divided by this time [s]; empty: without a limit
void removeApproach(const std::vector<Vec3>& before, const std::function<Vec3(std::size_t vertex)>& obstacleVelocity,
                    std::optional<double> spread, ClothState& state);

/// Limits the velocity of vertices in the direction opposite to their displacement from `before`, which contact can
/// leave. The limit is the mean velocity of the step in that direction, or 0 if that is negative.
/// @param before positions of the vertices before they were moved to those of `state` [m]
/// @param start positions at the start of the step [m]
/// @param timeStep of the step [s]
void limitApproach(const std::vector<Vec3>& before, const std::vector<Vec3>& start, double timeStep, ClothState& state);

}  // namespace drape::sim::contact
