#pragma once

#include "sim/contact/bodies/world.hpp"
#include "sim/model/vector.hpp"

#include <cstddef>
#include <vector>

namespace drape::report {

/// The number of intersecting pairs of a cloth triangle and a body triangle, by exact arithmetic
/// (intersection/intersections.hpp). Active bodies count as they are drawn, at the end of the step. For an infinite
/// plane each triangle that touches it or is below it counts once.
/// @param positions of the cloth [m]
/// @param triangles of the cloth
[[nodiscard]] std::size_t pairsWithBodies(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
                                          const sim::contact::BodyWorld& world);

}  // namespace drape::report
