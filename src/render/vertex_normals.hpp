#pragma once

#include "sim/vector.hpp"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace drape {

/// Unit normals of the vertices of a mesh, each the mean of its triangles' normals weighted by their area. A vertex
/// without any area around it gets a normal that points up. `normals` is resized to the number of positions; its
/// memory is reused.
void areaWeightedNormals(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                         std::vector<Eigen::Vector3f>& normals);

}  // namespace drape
