// The cost of self-collision in a step: over the two seconds in which a sheet that is pinned along its middle folds
// onto itself, with the search for near pairs and the growth of collision-free patches.
#include "bench/cloths.hpp"
#include "bench/suite.hpp"
#include "sim/stepping/stepper.hpp"

#include <string>

namespace drape::bench {
namespace {

constexpr int steps = 300;

ModelPtr foldingSheet(int n) {
  std::vector<int> pins;
  for (int column = 0; column < n; ++column) {
    pins.push_back(n / 2 * n + column);
  }
  return sim::buildClothModel(gridMesh(n), 0.1, sim::MassLumping::Uniform, pins);
}

sim::StepParameters folding(sim::contact::SelfCollision self) {
  sim::StepParameters parameters = stillAir();
  parameters.material.stiffness = 200.0;
  parameters.material.damping = 0.002;
  parameters.air.drag = 0.5;
  parameters.precision = sim::Precision::Float;
  parameters.contact.self = self;
  return parameters;
}

/// Runs a whole fold. Returns the time of its steps, or of self-collision alone.
Batch fold(int n, sim::contact::SelfCollision self) {
  const ModelPtr model = foldingSheet(n);
  return {static_cast<double>(steps), [model, self] {
            sim::Stepper stepper("one_iteration");
            sim::ClothState state = sim::stateAtRest(model->restPositions);
            const sim::StepParameters parameters = folding(self);
            double collision = 0.0;
            const double all = threadSeconds([&] {
              for (int i = 0; i < steps; ++i) {
                collision += stepper.step(*model, parameters, {}, state).contact.selfSeconds;
              }
            });
            return self == sim::contact::SelfCollision::Off ? all : collision;
          }};
}

}  // namespace

void addSelfCollisionGroup(Suite& suite) {
  for (const int n : {17, 33, 65}) {
    const std::string grid = std::to_string(n) + "x" + std::to_string(n);
    suite.add({"self-collision", grid + ", the step", "us/step"},
              [n] { return fold(n, sim::contact::SelfCollision::Off); });
    suite.add({"self-collision", grid + ", self-collision", "us/step"},
              [n] { return fold(n, sim::contact::SelfCollision::Hash); });
    const auto bound = n <= 33 ? std::optional(Bound{Bound::Side::AtMost, 2.0}) : std::nullopt;
    suite.addRatio({"self-collision", grid + ", self-collision / step", "self-collision/" + grid + ", self-collision",
                    "self-collision/" + grid + ", the step", bound});
  }
}

}  // namespace drape::bench
