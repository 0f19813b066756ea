#include "report/hardcases/strain_on_the_way.hpp"

#include "sim/forces/diagnostics.hpp"
#include "sim/stepping/stepper.hpp"

#include <algorithm>
#include <cmath>

namespace drape::report::hardcases {

double strainOnTheWay(WatchedCloth& watched, double seconds) {
  double largest = 0.0;
  const auto steps = std::lround(seconds / watched.simulation().settings().step.timeStep);
  for (long i = 0; i < steps; ++i) {
    watched.step();
    largest = std::max(largest, sim::maxStretch(watched.model(), watched.state()));
  }
  return largest;
}

double convergedStrain(const CaseTrial& trial, const CaseCloth& cloth, double seconds) {
  settings::Settings settings = cloth.settings;
  settings.solver.name = "verlet";
  settings.step.precision = sim::Precision::Double;
  const auto model = modelOf(cloth);
  settings.step.substeps = stableSubsteps(*model, settings);
  sim::Stepper stepper(settings.solver.name);
  sim::ClothState state = sim::stateAtRest(cloth.mesh.positions);
  double largest = 0.0;
  const auto steps = std::lround(seconds / settings.step.timeStep);
  for (long i = 0; i < steps; ++i) {
    trial.tick();
    stepper.step(*model, settings.step, {}, state);
    largest = std::max(largest, sim::maxStretch(*model, state));
  }
  return largest;
}

}  // namespace drape::report::hardcases
