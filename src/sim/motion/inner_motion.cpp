#include "sim/motion/inner_motion.hpp"

#include "sim/motion/rigid_motion.hpp"

namespace drape::sim {

InnerMotion::InnerMotion(const ClothModel& model, const std::vector<std::vector<std::size_t>>& pieces,
                         const ClothState& state)
    : rigid_(state.velocities.size(), Vec3::Zero()) {
  for (const auto& piece : pieces) {
    const MassMoments moments = momentsOf(model, piece, state.positions);
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
    for (const std::size_t v : piece) {
      const Vec3 momentum = model.vertexMass[v] * state.velocities[v];
      linear += momentum;
      angular += (state.positions[v] - moments.barycentre).cross(momentum);
    }
    const Vec3 spin = solveRigid(moments.inertia, angular);
    for (const std::size_t v : piece) {
      rigid_[v] = linear / moments.mass + spin.cross(state.positions[v] - moments.barycentre);
    }
  }
  for (std::size_t v = 0; v < rigid_.size(); ++v) {
    energy_ += 0.5 * model.vertexMass[v] * (state.velocities[v] - rigid_[v]).squaredNorm();
  }
}

void InnerMotion::scale(double factor, ClothState& state) const {
  for (std::size_t v = 0; v < rigid_.size(); ++v) {
    state.velocities[v] = rigid_[v] + factor * (state.velocities[v] - rigid_[v]);
  }
}

}  // namespace drape::sim
