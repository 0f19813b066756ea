#pragma once

#include "io/garments/flat_pattern.hpp"

#include <vector>

namespace drape::io {

/// The distance of each point of a front or a back from the plane of its seams: 0 at seams, growing to `height` [m] in
/// the middle of a wide piece. @param sewn whether each point is on a seam; later points are not
[[nodiscard]] std::vector<double> puffed(const FlatMesh& mesh, const std::vector<bool>& sewn, double edgeLength,
                                         double height);

}  // namespace drape::io
