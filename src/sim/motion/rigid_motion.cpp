#include "sim/motion/rigid_motion.hpp"

#include <Eigen/QR>

namespace drape::sim {

MassMoments momentsOf(const ClothModel& model, std::span<const std::size_t> vertices,
                      const std::vector<Vec3>& positions) {
  MassMoments moments;
  for (const std::size_t v : vertices) {
    moments.mass += model.vertexMass[v];
    moments.barycentre += model.vertexMass[v] * positions[v];
  }
  moments.barycentre /= moments.mass;
  for (const std::size_t v : vertices) {
    const Vec3 arm = positions[v] - moments.barycentre;
    moments.inertia += model.vertexMass[v] * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
  }
  return moments;
}

RigidMotion rigidMotionOf(const ClothModel& model, std::span<const std::size_t> vertices, const ClothState& state) {
  RigidMotion motion{.moments = momentsOf(model, vertices, state.positions)};
  Vec3 linear = Vec3::Zero();
  Vec3 angular = Vec3::Zero();
  for (const std::size_t v : vertices) {
    const Vec3 momentum = model.vertexMass[v] * state.velocities[v];
    linear += momentum;
    angular += (state.positions[v] - motion.moments.barycentre).cross(momentum);
  }
  motion.velocity = linear / motion.moments.mass;
  motion.spin = solveRigid(motion.moments.inertia, angular);
  return motion;
}

Vec3 solveRigid(const Mat3& matrix, const Vec3& rightSide) {
  constexpr double negligible = 1e-9;
  Eigen::CompleteOrthogonalDecomposition<Mat3> decomposition;
  decomposition.setThreshold(negligible);
  decomposition.compute(matrix);
  return decomposition.solve(rightSide);
}

}  // namespace drape::sim
