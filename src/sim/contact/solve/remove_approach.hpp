#pragma once

#include "sim/model/cloth_state.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace drape::sim::contact {

/// Removes the velocity of vertices towards what moved them.
/// @param before positions of the vertices before they were moved to those of `state` [m]
/// @param obstacleVelocity velocity of what moved a vertex [m/s]
/// @param spread time over which a displacement may change the velocity [s]: it changes by at most displacement /
/// spread; without it there is no limit
void removeApproach(const std::vector<Vec3>& before, const std::function<Vec3(std::size_t vertex)>& obstacleVelocity,
                    std::optional<double> spread, ClothState& state);

/// Limits the velocity of vertices in the direction opposite to their displacement from `before`. The limit is the mean
/// velocity of the step in that direction.
/// @param before positions of the vertices before they were moved to those of `state` [m]
/// @param start positions at the start of the step [m]
/// @param timeStep of the step [s]
void limitApproach(const std::vector<Vec3>& before, const std::vector<Vec3>& start, double timeStep, ClothState& state);

}  // namespace drape::sim::contact
