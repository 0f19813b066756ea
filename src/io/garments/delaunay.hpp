#pragma once

#include "sim/model/vector.hpp"

#include <vector>

namespace drape::io {

/// The Delaunay triangulation of points in a plane, counter-clockwise. It maximises the smallest angle. For patterns of
/// a few thousand points; the cost is quadratic.
[[nodiscard]] std::vector<Triangle> delaunay(const std::vector<Vec2>& points);

}  // namespace drape::io
