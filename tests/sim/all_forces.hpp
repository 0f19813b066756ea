#pragma once

#include "sim/forces/external_forces.hpp"
#include "sim/forces/forces.hpp"
#include "sim/forces/step_inputs.hpp"
#include "sim/model/workers.hpp"

#include <vector>

namespace drape::sim::testing {

/// The forces on all vertices: springs, damping, gravity, air and the attachment [N]. Pinned vertices have them too.
/// @param force one a vertex; resized
inline void evaluateForces(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs,
                           const ClothState& state, Workers& workers, std::vector<Vec3>& force) {
  force.resize(state.positions.size());
  workers.forEach(parameters.threads, force.size(), [&](std::size_t i) {
    force[i] = internalForceOn(model, parameters, state, i) + gravityAndAir(model, parameters, state, i);
  });
  if (inputs.attachment) {
    const AttachmentForce pull = attachmentForce(model, *inputs.attachment, state);
    pull.forEach([&](std::size_t v, double weight) { force[v] += weight * pull.force; });
  }
}

}  // namespace drape::sim::testing
