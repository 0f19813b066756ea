#pragma once

#include "sim/model/cloth_model.hpp"

#include <span>

namespace drape::sim {

/// Mass, barycentre and tensor of inertia of some vertices.
struct MassMoments {
  double mass = 0.0;               ///< [kg]
  Vec3 barycentre = Vec3::Zero();  ///< [m]
  Mat3 inertia = Mat3::Zero();     ///< about the barycentre [kg m^2]; singular if the vertices are collinear
};

[[nodiscard]] MassMoments momentsOf(const ClothModel& model, std::span<const std::size_t> vertices,
                                    const std::vector<Vec3>& positions);

/// The shortest x with matrix x = right side, in the sense of least squares if the matrix is singular. The rotation
/// about an axis without inertia is then zero.
[[nodiscard]] Vec3 solveRigid(const Mat3& matrix, const Vec3& rightSide);

}  // namespace drape::sim
