#include "dressing/fitting.hpp"

#include <algorithm>
#include <utility>

namespace drape::dressing {
namespace {

std::shared_ptr<const std::vector<sim::contact::Body>> growingBody(const ShrinkingBody& body, std::size_t frame) {
  sim::contact::Body growing;
  growing.shape = body.growingFrom(frame, Fitting::growthSpeed);
  growing.motion.keyframes = {sim::contact::Keyframe{}};
  growing.surface.staticFriction = 0.0;
  growing.surface.kineticFriction = 0.0;
  return std::make_shared<const std::vector<sim::contact::Body>>(1, std::move(growing));
}

}  // namespace

Fitting::Fitting(const sim::ClothModel& model, std::vector<Vec3> positions, const ShrinkingBody& body,
                 std::size_t frame, const sim::StepParameters& parameters)
    : model_(withSprings(model)),
      growthTime_(body.wayTo(frame) / growthSpeed),
      world_(growingBody(body, frame), 0.0),
      state_(sim::stateAtRest(std::move(positions))),
      stepper_("one_iteration") {
  parameters_.material = parameters.material;
  parameters_.contact = parameters.contact;
  parameters_.contact.bodies = true;
  parameters_.contact.self = sim::contact::SelfCollision::Exact;
  parameters_.threads = parameters.threads;
  parameters_.timeStep = stepSeconds;
  parameters_.gravity = 0.0;
}

void Fitting::step() {
  std::fill(state_.velocities.begin(), state_.velocities.end(), Vec3::Zero());
  world_.advance(state_.time, stepSeconds);
  sim::StepInputs inputs;
  inputs.bodies = &world_.steps();
  stepper_.step(*model_, parameters_, inputs, state_);
}

}  // namespace drape::dressing
