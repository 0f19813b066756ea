#include "sim/measures/energy_balance.hpp"

#include "sim/contact/bodies/body.hpp"
#include "sim/forces/external_forces.hpp"
#include "sim/forces/forces.hpp"
#include "sim/forces/kernels.hpp"
#include "sim/forces/stability.hpp"

#include <algorithm>

namespace drape::sim {
namespace {

/// The work of -C_d (v_a - v_b) on a and its opposite on b, for all springs.
double dampingWork(const ClothModel& model, double damping, const ClothState& before, const ClothState& after) {
  if (damping == 0.0) {
    return 0.0;
  }
  double work = 0.0;
  for (const Spring& spring : model.springs) {
    const auto a = static_cast<std::size_t>(spring.a);
    const auto b = static_cast<std::size_t>(spring.b);
    const Vec3 force = 0.5 * (kernels::dampingForce(before.velocities[a], before.velocities[b], damping) +
                              kernels::dampingForce(after.velocities[a], after.velocities[b], damping));
    const Vec3 relative = (after.positions[a] - before.positions[a]) - (after.positions[b] - before.positions[b]);
    work += relative.dot(force);
  }
  return work;
}

double airWork(const ClothModel& model, const StepParameters& parameters, const ClothState& before,
               const ClothState& after) {
  if (!parameters.air.acts()) {
    return 0.0;
  }
  StepParameters airOnly = parameters;
  airOnly.gravity = 0.0;
  // The air's force is limited to the force that stops a vertex within a substep.
  airOnly.timeStep = parameters.timeStep / parameters.substeps;
  double work = 0.0;
  for (std::size_t i = 0; i < after.positions.size(); ++i) {
    const Vec3 motion = after.positions[i] - before.positions[i];
    if (!motion.isZero(0.0)) {
      work += 0.5 * motion.dot(gravityAndAir(model, airOnly, before, i) + gravityAndAir(model, airOnly, after, i));
    }
  }
  return work;
}

/// The reaction force on a pinned vertex [N].
Vec3 reactionForce(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                   std::size_t vertex) {
  return -internalForceOn(model, parameters, state, vertex) - gravityAndAir(model, parameters, state, vertex);
}

/// The work on the pins that move in the step, with bodies or without.
double pinWork(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
               const ClothState& before, const ClothState& after) {
  StepParameters part = parameters;
  part.timeStep = parameters.timeStep / parameters.substeps;
  double work = 0.0;
  const auto add = [&](int vertex) {
    const auto v = static_cast<std::size_t>(vertex);
    if (model.pinned[v]) {
      const Vec3 motion = after.positions[v] - before.positions[v];
      work += 0.5 * motion.dot(reactionForce(model, part, before, v) + reactionForce(model, part, after, v));
    }
  };
  if (inputs.bodies != nullptr) {
    for (const contact::BodyStep& body : *inputs.bodies) {
      std::ranges::for_each(body.body->pins, [&](const contact::CarriedPin& pin) { add(pin.vertex); });
    }
  }
  if (inputs.movedPins != nullptr) {
    std::ranges::for_each(*inputs.movedPins, [&](const MovedPin& pin) { add(pin.vertex); });
  }
  return work;
}

double attachmentWork(const ClothModel& model, const Attachment& attachment, const ClothState& before,
                      const ClothState& after) {
  const AttachmentForce first = attachmentForce(model, attachment, before);
  const AttachmentForce last = attachmentForce(model, attachment, after);
  return 0.5 * attachedPointMotion(first, before, after).dot(first.force + last.force);
}

}  // namespace

void EnergyBalance::add(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                        const ClothState& before, const ClothState& after, const ClothState* unresolved,
                        const WorkApart& apart) {
  const double end = energyOf(model, parameters, after).total();
  change_ += end - energyOf(model, parameters, before).total();
  contact_ += apart.earlierContact;
  damping_ += apart.damping;
  air_ += apart.unsteadyAir;
  if (unresolved != nullptr) {
    contact_ += end - energyOf(model, parameters, *unresolved).total();
  }
  const ClothState& solved = unresolved != nullptr ? *unresolved : after;  // without the correction by contact
  damping_ += dampingWork(model, actingMaterial(model, parameters).damping, before, solved);
  air_ += airWork(model, parameters, before, solved);
  contact_ += pinWork(model, parameters, inputs, before, solved);
  if (inputs.attachment) {
    attachment_ += attachmentWork(model, *inputs.attachment, before, solved);
  }
}

}  // namespace drape::sim
