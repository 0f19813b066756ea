#pragma once

#include "sim/model/cloth_model.hpp"

#include <span>
#include <vector>

namespace drape::sim::fabric {

/// The damping of bending for a damping time of one second, as the matrix Z = sum_i Delta_i^T d_i d_i^T Delta_i / a_i
/// over all vertices i that are not on the boundary.
///
/// | symbol  | meaning                                                                      | unit      |
/// |---------|------------------------------------------------------------------------------|-----------|
/// | Delta_i | row of sqrt(B_1) d^2/dX_1^2 + sqrt(B_2) d^2/dX_2^2 times a_i, by linear      | sqrt(N m) |
/// |         | finite elements                                                              |           |
/// | d_i     | unit direction of Delta_i x, normal to the cloth; the normal where it is flat | -         |
/// | a_i     | area of the vertex                                                           | m^2       |
///
/// d_i . Delta_i v is the rate of the mean curvature, weighted by the bending stiffness along warp and weft. In rigid
/// motion the vector Delta_i x only turns, so its rate is perpendicular to d_i and is not damped. Z is symmetric, so it
/// conserves momentum, and angular momentum to the same accuracy: d_i deviates from Delta_i x where cloth is almost
/// flat. A wave along warp or weft has the damping of the bending stiffness B_1 or B_2. Twist is damped with the
/// stiffness sqrt(B_1 B_2) / 2 instead of D_33 (bendMatrix).
struct BendingDamping {
  std::vector<double> weights;       ///< entries of Delta, one for each of ClothModel::springs [sqrt(N m)]
  std::vector<double> inverseAreas;  ///< 1 / a_i [1/m^2], one a vertex; 0 on the boundary
  double highestRate = 0.0;          ///< an upper bound of the eigenvalues of M^-1 Z [1/s^2]
};

/// @param model must have a fabric
[[nodiscard]] BendingDamping bendingDampingOf(const ClothModel& model);

/// d_i of a vertex; zero where 1 / a_i is.
[[nodiscard]] Vec3 bendingDirection(const ClothModel& model, const BendingDamping& damping,
                                    std::span<const Vec3> positions, int vertex);

/// The element of a vertex of Delta applied to vectors, one a vertex [sqrt(N m) times their unit]. Delta is symmetric.
[[nodiscard]] Vec3 weightedLaplacian(const ClothModel& model, const BendingDamping& damping,
                                     std::span<const Vec3> vectors, int vertex);

}  // namespace drape::sim::fabric
