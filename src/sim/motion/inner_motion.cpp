#include "sim/motion/inner_motion.hpp"

#include "sim/motion/rigid_motion.hpp"

namespace drape::sim {

InnerMotion::InnerMotion(const ClothModel& model, const std::vector<std::vector<std::size_t>>& pieces,
                         const ClothState& state)
    : rigid_(state.velocities.size(), Vec3::Zero()) {
  for (const auto& piece : pieces) {
    const RigidMotion motion = rigidMotionOf(model, piece, state);
    for (const std::size_t v : piece) {
      rigid_[v] = motion.velocityAt(state.positions[v]);
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
