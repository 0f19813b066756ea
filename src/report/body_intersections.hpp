#pragma once

#include "sim/contact/bodies/world.hpp"
#include "sim/vector.hpp"

#include <cstddef>
#include <vector>

namespace drape {

/// How many pairs of a cloth's triangle and a body's triangle intersect, by exact arithmetic
/// (intersection/intersections.hpp). Bodies that are on count as they are drawn, where they are at the end of the step.
/// A plane is not the square that is drawn: each triangle that touches it or is below it counts once.
/// @param positions of the cloth [m]
/// @param triangles of the cloth
[[nodiscard]] std::size_t pairsWithBodies(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
                                          const BodyWorld& world);

}  // namespace drape
