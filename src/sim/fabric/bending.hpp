#pragma once

#include "sim/fabric/material.hpp"
#include "sim/fabric/rest_shape.hpp"

#include <Eigen/SparseCore>
#include <cstddef>
#include <span>
#include <vector>

namespace drape::sim::fabric {

/// A symmetric matrix with a row for each vertex.
using VertexMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The bending stiffness of a fabric that is flat at rest, as a matrix L over the vertices [N/m]: the energy is
/// 1/2 sum_ij L_ij x_i.x_j and the force on vertex i is -sum_j L_ij x_j. L is positive semidefinite and constant.
///
/// | symbol   | meaning                                                                                      | unit |
/// |----------|----------------------------------------------------------------------------------------------|------|
/// | kappa    | curvature (k_11, k_22, 2 k_12) of a triangle along warp and weft, three vectors              | 1/m  |
/// | s_e      | slope at the middle of side e: the derivative of x along the outward normal n_e              | -    |
/// | s_Te     | slope of the plane triangle: its derivative of x along n_e                                   | -    |
/// | u_e      | bend vector of a hinge, the sum of s_Te of its two triangles, see Hinge::weights             | -    |
/// | l_e, A   | length of the side, area of the triangle                                                     | m    |
///
/// The energy of a triangle is A/2 kappa^T D kappa. Its curvature follows from Gauss's theorem with the slopes at its
/// sides: kappa = sum_e l_e / A N(n_e) (s_e - s_Te) with N(n) = (n_1^2, n_2^2, 2 n_1 n_2). Two triangles share the
/// slope at their common edge, so that a constant moment is in equilibrium. The slope is exact for every quadratic
/// field, so that a constant curvature has its exact energy. Both together make the stiffness the same on every mesh
/// once it is fine enough. The slope is interpolated between the slopes of the two triangles, and corrected for the
/// curvature of the quadratic fields through each triangle and its neighbours' corners (the patches of Phaal and
/// Calladine, 1992, A simple class of finite elements for plate and shell problems, and of Flores and Onate, 2005,
/// Improvements in the membrane behaviour of the three node rotation-free BST shell triangle).
///
/// For an isometric hinge u_e is normal to the surface and has the length 2 sin(theta / 2), with theta the angle
/// between the triangles (Bergou et al. 2006, A quadratic bending model for inextensible surfaces). So the energy does
/// not change in rigid motion and grows less than with theta^2 for sharp folds.
///
/// The bend vectors at slivers (sliverQuality) are scaled down, so that they do not determine the time step.
/// Edges on the boundary are free of moments. Edges of three or more triangles bend freely.
[[nodiscard]] VertexMatrix bendingMatrix(const RestShape& shape, const TriangleMaterials& materials,
                                         std::size_t vertexCount);

/// The curvatures of triangles as a linear function of the positions.
using CurvatureMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// kappa of bendingMatrix, with three rows a triangle and a column for each vertex [1/m^2]. The rows sum to zero.
[[nodiscard]] CurvatureMatrix curvatureMatrix(const RestShape& shape, const TriangleMaterials& materials,
                                              std::size_t vertexCount);

/// Half the sum of |L_ij| over each row [N/m]. By Gershgorin's theorem the highest frequency of bending has
/// omega^2 <= 2 max_i(half sum_i / m_i).
[[nodiscard]] std::vector<double> halfRowSums(const VertexMatrix& bending);

/// The moments of a fabric that is flat at rest, in a given shape [N]: the derivative of the bending energy by the bend
/// vector of each hinge. @param scales the factor on the energy of each triangle; empty: 1  @param positions [m]
[[nodiscard]] std::vector<Vec3> hingeMoments(const RestShape& shape, const TriangleMaterials& materials,
                                             std::span<const double> scales, std::span<const Vec3> positions);

/// The bending stiffness with clamped triangles.
struct ClampedBending {
  VertexMatrix matrix;
  std::vector<double> scales;  ///< the factor on the bending energy of each triangle [-]
};

/// The same matrix, with the energy of the stiffest triangles scaled down to the RateLimit of the mesh. Each triangle's
/// energy stays free of rigid motion and positive, so the matrix is semidefinite too.
/// @param vertexAreas of all vertices [m^2]  @param maxRatio, clothOf as in RateLimit
[[nodiscard]] ClampedBending clampedBendingMatrix(const RestShape& shape, const TriangleMaterials& materials,
                                                  std::span<const double> vertexAreas, double maxRatio,
                                                  std::span<const int> clothOf = {});

}  // namespace drape::sim::fabric
