#include "sim/forces.hpp"

#include "sim/external_forces.hpp"
#include "sim/kernels.hpp"

namespace drape {

Vec3 springForcesOn(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                    std::size_t vertex) {
  Vec3 force = Vec3::Zero();
  const auto begin = static_cast<std::size_t>(model.springEnds.begin[vertex]);
  const auto end = static_cast<std::size_t>(model.springEnds.begin[vertex + 1]);
  for (std::size_t e = begin; e < end; ++e) {
    const SpringEnd& springEnd = model.springEnds.values[e];
    const auto neighbour = static_cast<std::size_t>(springEnd.neighbour);
    const Spring& spring = model.springs[static_cast<std::size_t>(springEnd.spring)];
    force += kernels::springForce(state.positions[neighbour] - state.positions[vertex], spring.restLength,
                                  parameters.stiffness * spring.relativeStiffness);
    force += kernels::dampingForce(state.velocities[vertex], state.velocities[neighbour], parameters.damping);
  }
  return force;
}

void evaluateForces(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                    const ClothState& state, Workers& workers, std::vector<Vec3>& force) {
  force.resize(state.positions.size());
  workers.forEach(parameters.threads, force.size(), [&](std::size_t i) {
    force[i] = springForcesOn(model, parameters, state, i) + gravityAndAir(model, parameters, state, i);
  });
  if (inputs.attachment) {
    const AttachmentForce pull = attachmentForce(model, *inputs.attachment, state);
    for (std::size_t c = 0; c < 3; ++c) {
      force[pull.vertices[c]] += pull.weights[static_cast<Eigen::Index>(c)] * pull.force;
    }
  }
}

}  // namespace drape
