#pragma once

#include "sim/fabric/material.hpp"
#include "sim/fabric/rest_shape.hpp"

#include <Eigen/SparseCore>
#include <cstddef>

namespace drape::sim::fabric {

/// A symmetric matrix with a row for each vertex.
using VertexMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The bending stiffness of a fabric that is flat at rest, as a matrix L over the vertices [N/m]: the energy is
/// 1/2 sum_ij L_ij x_i.x_j and the force on vertex i is -sum_j L_ij x_j. L is positive semidefinite and constant.
///
/// | symbol  | meaning                                                                                        | unit |
/// |---------|------------------------------------------------------------------------------------------------|------|
/// | u_e     | bend vector of hinge e: the derivatives of x along the outward normals of its edge in its two  | -    |
/// |         | triangles, added; u_e = sum_i w_i x_i with the cotangent weights of the rest shape             |      |
/// | l_e     | length of the edge at rest                                                                     | m    |
/// | n_e     | unit normal of the edge in the plane of a triangle, along warp and weft                        | -    |
/// | kappa   | curvature (k_11, k_22, 2 k_12) of a triangle, three vectors: sum_e l_e / (2 A) N(n_e) u_e      | 1/m  |
///
/// with N(n) = (n_1^2, n_2^2, 2 n_1 n_2). The energy of a triangle is A/2 kappa^T D kappa.
///
/// For an isometric hinge u_e is normal to the surface and has the length 2 sin(theta / 2), with theta the angle
/// between the triangles. So the energy does not change in rigid motion and grows less than with theta^2 for sharp
/// folds. The bend vectors are those of Bergou et al. (2006, A quadratic bending model for inextensible surfaces). The
/// curvature of a triangle is the discrete shape operator of Grinspun et al. (2006, Computing discrete shape operators
/// on general meshes). Its stiffness agrees with closed forms on
/// grids, and is too large on irregular meshes and for twist on alternating ones (docs/theory/fabric.md).
///
/// The bend vectors at slivers (sliverQuality) are scaled down, so that they do not determine the time step.
/// Edges on the boundary are free of moments. Edges of three or more triangles bend freely.
[[nodiscard]] VertexMatrix bendingMatrix(const RestShape& shape, const Material& material, std::size_t vertexCount);

}  // namespace drape::sim::fabric
