#pragma once

#include "sim/model/vector.hpp"

#include <span>

namespace drape::sim::contact {

/// The distance by which self-collision may move a vertex in a step [m]: the largest motion in the step plus four
/// thicknesses. Where pins or bodies move towards each other like scissors, contact constraints have no solution, or
/// one that is far away.
/// @param start, end positions of the step before the correction [m]  @param thickness of the cloth [m]
[[nodiscard]] double largestCorrection(std::span<const Vec3> start, std::span<const Vec3> end, double thickness);

/// Limits the correction of each vertex to `limit` [m]. @param before, after positions without and with it [m]
void limitCorrections(double limit, std::span<const Vec3> before, std::span<Vec3> after);

/// Limits the speed that self-collision may give a vertex to the larger one of the speed of the fastest vertex before
/// and three times that of the fastest pin. Without moving pins there is no limit, since contact adds no energy then.
/// @param inverseMass of the vertices; 0: pinned [1/kg]  @param pinSpeed of the fastest pin [m/s]
/// @param before, after velocities without and with self-collision [m/s]
void limitSpeeds(std::span<const double> inverseMass, double pinSpeed, std::span<const Vec3> before,
                 std::span<Vec3> after);

}  // namespace drape::sim::contact
