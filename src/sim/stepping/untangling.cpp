#include "sim/stepping/untangling.hpp"

#include "sim/stepping/flat_layers.hpp"

#include <algorithm>
#include <utility>

namespace drape::sim {

Untangling::Untangling(std::shared_ptr<const ClothModel> model, std::vector<Vec3> positions,
                       const StepParameters& parameters)
    : model_(std::move(model)), state_(stateAtRest(std::move(positions))), stepper_("one_iteration") {
  parameters_.material = parameters.material;
  parameters_.contact = parameters.contact;
  parameters_.contact.self = contact::SelfCollision::Exact;
  parameters_.threads = parameters.threads;
  parameters_.timeStep = stepSeconds;
  parameters_.gravity = 0.0;
}

void Untangling::openFlatLayers(std::span<const intersection::TrianglePair> pairs) {
  sim::openFlatLayers(*model_, pairs, parameters_.contact.thickness, state_.positions);
}

void Untangling::step() {
  std::fill(state_.velocities.begin(), state_.velocities.end(), Vec3::Zero());
  stepper_.step(*model_, parameters_, {}, state_);
}

}  // namespace drape::sim
