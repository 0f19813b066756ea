#include "report/sections/contact_reference.hpp"

#include "report/sections/cloth_with_reference.hpp"
#include "report/sections/stable_substeps.hpp"
#include "sim/measures/measures.hpp"
#include "sim/solvers/solver.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace drape::report::sections {
namespace {

constexpr int maxHalvings = 5;
constexpr double tolerance = 1e-5;  // [m]
/// A halving that leaves more than this part of the difference does not help.
constexpr double helpful = 0.7;
constexpr int pairs = 2;

/// Twice as many substeps as stability needs.
void makeStable(const scene::Scene& scene, settings::Settings& settings) {
  settings.step.substeps = 2 * stableSubsteps(*sim::findSolver("verlet"), *scene.model, settings.step);
}

settings::Settings firstSettings(const scene::Scene& scene, const settings::Settings& method) {
  settings::Settings settings = convergedSettings(method);
  makeStable(scene, settings);
  return settings;
}

/// Half the time step. Substeps become shorter too, by a factor of 1.4, so that the error of Verlet shrinks as well.
settings::Settings finerThan(settings::Settings settings) {
  constexpr double root = 0.70710678;
  settings.step.timeStep *= 0.5;
  settings.step.substeps = static_cast<int>(std::ceil(root * settings.step.substeps));
  return settings;
}

/// The rough duration of a run on one core [s].
double expectedSeconds(const scene::Scene& scene, const settings::Settings& settings, int checkpoints) {
  constexpr double contactOfTriangle = 1e-6;
  constexpr double forceOfSpring = 4e-9;
  const double steps = checkpoints * checkpointInterval / settings.step.timeStep;
  const sim::ClothModel& model = *scene.model;
  return steps * (contactOfTriangle * static_cast<double>(model.triangles.size()) +
                  forceOfSpring * settings.step.substeps * static_cast<double>(model.springs.size()));
}

/// The distances of the checkpoints of two runs [m].
std::vector<double> distances(const Trajectory& a, const Trajectory& b) {
  std::vector<double> all(std::min(a.states.size(), b.states.size()));
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k] = sim::meanDistance(a.states[k].positions, b.states[k].positions);
  }
  return all;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? std::numeric_limits<double>::infinity() : *std::max_element(values.begin(), values.end());
}

std::vector<double> partingOf(const scene::Scene& scene, const settings::Settings& settings, const Trajectory& still,
                              const Watch& watch) {
  std::vector<double> mean(still.states.size(), 0.0);
  for (int seed = 1; seed <= pairs; ++seed) {
    const auto start = jittered(scene, jitterLength, static_cast<unsigned>(seed));
    const std::vector<double> moved = distances(still, runTrajectory(*start, settings, still.checkpoints(), watch));
    mean.resize(std::min(mean.size(), moved.size()));
    for (std::size_t k = 0; k < mean.size(); ++k) {
      mean[k] += moved[k] / pairs;
    }
  }
  return mean;
}

}  // namespace

ContactReference contactReference(const scene::Scene& scene, const settings::Settings& method, int checkpoints,
                                  double maxSeconds, const std::function<void()>& checkStop) {
  Watch watch;
  watch.progress = [&checkStop](std::string_view, std::int64_t, std::int64_t) { checkStop(); };
  ContactReference result;
  Reference& reference = result.reference;
  reference.kind = ReferenceKind::Converged;
  reference.settings = firstSettings(scene, method);
  reference.trajectory = runTrajectory(scene, reference.settings, checkpoints, watch);
  // Where contact in long steps deforms the cloth so much that it blows up, the first step is shorter.
  while (reference.trajectory.checkpoints() < checkpoints) {
    reference.settings.step.timeStep *= 0.5;
    makeStable(scene, reference.settings);
    if (expectedSeconds(scene, reference.settings, checkpoints) > maxSeconds) {
      break;
    }
    reference.trajectory = runTrajectory(scene, reference.settings, checkpoints, watch);
  }
  reference.differences.assign(reference.trajectory.states.size(), std::numeric_limits<double>::infinity());
  result.parting = partingOf(scene, reference.settings, reference.trajectory, watch);
  int fruitless = 0;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < maxHalvings && last > tolerance && fruitless < 2; ++i) {
    const settings::Settings finer = finerThan(reference.settings);
    if (expectedSeconds(scene, finer, checkpoints) > maxSeconds) {
      break;
    }
    Trajectory run = runTrajectory(scene, finer, checkpoints, watch);
    reference.differences = distances(reference.trajectory, run);
    const double difference = largest(reference.differences);
    fruitless = difference < helpful * last ? 0 : fruitless + 1;
    last = difference;
    reference.settings = finer;
    reference.trajectory = std::move(run);
    reference.halvings.push_back({finer.step.timeStep, difference, 0});
  }
  // A start next to one that arrives in long steps can blow up in them.
  if (result.parting.size() < reference.trajectory.states.size()) {
    result.parting = partingOf(scene, reference.settings, reference.trajectory, watch);
  }
  reference.trusted = reference.trajectory.checkpoints();
  return result;
}

}  // namespace drape::report::sections
