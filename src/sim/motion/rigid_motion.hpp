#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

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

/// The rigid motion of some vertices that has their momentum.
struct RigidMotion {
  MassMoments moments;
  Vec3 velocity = Vec3::Zero();  ///< of the barycentre [m/s]
  Vec3 spin = Vec3::Zero();      ///< angular velocity [1/s]

  /// The velocity at a position [m/s].
  [[nodiscard]] Vec3 velocityAt(const Vec3& position) const {
    return velocity + spin.cross(position - moments.barycentre);
  }
  /// [J]
  [[nodiscard]] double kineticEnergy() const {
    return 0.5 * (moments.mass * velocity.squaredNorm() + spin.dot(moments.inertia * spin));
  }
};

[[nodiscard]] RigidMotion rigidMotionOf(const ClothModel& model, std::span<const std::size_t> vertices,
                                        const ClothState& state);

/// The shortest x with matrix x = right side, in the sense of least squares if the matrix is singular. The rotation
/// about an axis without inertia is then zero.
[[nodiscard]] Vec3 solveRigid(const Mat3& matrix, const Vec3& rightSide);

}  // namespace drape::sim
