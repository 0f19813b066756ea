#pragma once

#include "sim/fields/field_geometry.hpp"
#include "sim/model/cloth_model.hpp"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace drape::sim::fields {

/// Where warp and weft of a triangle run in the mesh at rest: unit vectors in its plane, at a right angle.
using WarpAndWeft = Eigen::Matrix<double, 3, 2>;

/// Of each triangle; zero for a degenerate one. @param geometry of `model`
[[nodiscard]] std::vector<WarpAndWeft> warpAndWeftOf(const ClothModel& model, const FieldGeometry& geometry);

/// Writes the stretch of the cloth at each vertex against its rest shape: the mean of 1 + Q (C - 1) Q^T over its
/// triangles, weighted by their area at rest [-]. C is as in computations.hpp, and Q has warp and weft as columns. So
/// the tensor refers to directions of the mesh at rest, which all triangles share. For a unit vector d along the cloth,
/// sqrt(d^T T d) is the present length along d over that at rest. Across the cloth it is 1. The identity for a vertex
/// without a triangle that has an area.
/// @param geometry of `model`  @param frames of warpAndWeftOf  @param positions one a vertex [m]
/// @param tensors one a vertex
void stretchTensors(const ClothModel& model, const FieldGeometry& geometry, std::span<const WarpAndWeft> frames,
                    std::span<const Vec3> positions, std::span<Mat3> tensors);

}  // namespace drape::sim::fields
