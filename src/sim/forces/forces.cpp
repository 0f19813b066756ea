#include "sim/forces/forces.hpp"

#include "sim/fabric/fabric.hpp"
#include "sim/forces/kernels.hpp"

namespace drape::sim {

Vec3 internalForceOn(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                     std::size_t vertex) {
  if (model.fabric) {
    return fabric::elasticForceOn(model, state.positions, vertex);
  }
  Vec3 force = Vec3::Zero();
  for (const SpringEnd& springEnd : model.springEnds[vertex]) {
    const int neighbour = springEnd.neighbour;
    const Spring& spring = model.springs[springEnd.spring];
    force += kernels::springForce(state.positions[neighbour] - state.positions[vertex], spring.restLength,
                                  parameters.material.stiffness * spring.relativeStiffness);
    force += kernels::dampingForce(state.velocities[vertex], state.velocities[neighbour], parameters.material.damping);
  }
  return force;
}

double stretchStiffness(const ClothModel& model, const CommonParameters& parameters) {
  return model.fabric ? fabric::minStretchModulus(model) : parameters.material.stiffness;
}

}  // namespace drape::sim
