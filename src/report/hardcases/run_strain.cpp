#include "report/hardcases/run_strain.hpp"

#include "sim/forces/diagnostics.hpp"
#include "sim/stepping/stepper.hpp"

#include <algorithm>
#include <cmath>

namespace drape::report::hardcases {

namespace {

/// maxStrainOfRun for Verlet at half of its limit, in double.
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

}  // namespace

double maxStrainOfRun(WatchedCloth& watched, double seconds) {
  double largest = 0.0;
  const auto steps = std::lround(seconds / watched.simulation().settings().step.timeStep);
  for (long i = 0; i < steps; ++i) {
    watched.step();
    largest = std::max(largest, sim::maxStretch(watched.model(), watched.state()));
  }
  return largest;
}

void expectStrain(CaseTrial& trial, const CaseCloth& cloth, double seconds, double limit) {
  const double converged = convergedStrain(trial, cloth, seconds);
  WatchedCloth watched(trial, cloth);
  trial.expect("strain", "times the converged solve's", maxStrainOfRun(watched, seconds) / converged, limit);
}

}  // namespace drape::report::hardcases
