#pragma once

#include "sim/vector.hpp"

#include <vector>

namespace drape {

/// The Delaunay triangulation of points in a plane, counter-clockwise: of all triangulations the one whose smallest
/// angle is largest. For patterns of a few thousand points; the cost grows with their square.
[[nodiscard]] std::vector<Triangle> delaunay(const std::vector<Vec2>& points);

}  // namespace drape
