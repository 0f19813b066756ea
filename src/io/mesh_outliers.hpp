#pragma once

#include "io/mesh_import.hpp"

#include <vector>

namespace drape::io {

/// The vertices far from all others, in ascending order: at most one in twenty, and at least twenty times farther from
/// the centre than the rest. The centre is the median of each coordinate, so that outliers do not move it. Only
/// vertices with faces count. Meshes with fewer than ten other vertices have no outliers.
[[nodiscard]] std::vector<int> findOutliers(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles);

/// The median length of the edges longer than 0, in the unit of the positions; 0 when there are none. An edge with two
/// faces counts twice.
[[nodiscard]] double medianEdge(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles);

}  // namespace drape::io
