#pragma once

#include "io/mesh_import.hpp"

#include <vector>

namespace drape {

/// The vertices, in ascending order, that lie far from all others: at most one in twenty, and at least twenty times
/// farther from the middle than the farthest of the rest. The middle is the median of each coordinate, so outliers do
/// not move it. Only vertices of faces count. Meshes with fewer than ten other vertices have no outliers.
[[nodiscard]] std::vector<int> findOutliers(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles);

/// The median length of the edges that are longer than 0, in the unit of the positions; 0 when there are none. An edge
/// with two faces counts twice.
[[nodiscard]] double medianEdge(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles);

}  // namespace drape
