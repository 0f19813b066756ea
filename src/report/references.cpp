#include "report/references.hpp"

#include "messages/error.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/measures/measures.hpp"
#include "sim/solvers/solver.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace drape::report {
namespace {

/// The number of consecutive halvings without improvement that ends the search.
constexpr int maxFruitless = 3;
/// A halving that leaves more than this fraction of the difference is no improvement.
constexpr double helpful = 0.7;

std::string timeOf(int checkpoint) {
  return fmt::format("{:.3g} s", checkpoint * checkpointInterval);
}

void requireMotion(const Reference& reference) {
  if (reference.trajectory.checkpoints() < 1) {
    throw messages::InputError("the reference (" + reference.settings.solver.name +
                               ") blew up before the first checkpoint; use a shorter step or another solver with "
                               "--reference-set");
  }
}

std::string blewUp(const Reference& reference) {
  return "The reference blew up after " + timeOf(reference.trajectory.checkpoints()) +
         "; later checkpoints have no reference.";
}

Reference runOnce(ReferenceKind kind, const scene::Scene& scene, const settings::Settings& settings, int checkpoints,
                  const Watch& watch) {
  Reference reference;
  reference.kind = kind;
  reference.settings = settings;
  reference.trajectory = runTrajectory(scene, settings, checkpoints, watch);
  reference.trusted = reference.trajectory.checkpoints();
  requireMotion(reference);
  if (!reference.trajectory.finite) {
    reference.doubt = blewUp(reference);
  }
  return reference;
}

/// The same steps as substeps of longer steps, so that a solver converts its own representation of the cloth less
/// often. The damping of a fabric acts once in a step, so its error shrinks only if the steps themselves are short.
settings::Settings inLongSteps(const scene::Scene& scene, settings::Settings settings) {
  constexpr int longest = 64;
  if (scene.model->fabric && scene.model->fabric->materials.damp()) {
    return settings;
  }
  int steps = stepsPerCheckpoint(settings.step.timeStep);
  int parts = 1;
  for (; steps % 2 == 0 && parts < longest; steps /= 2) {
    parts *= 2;
  }
  settings.step.timeStep = checkpointInterval / steps;
  settings.step.substeps *= parts;
  return settings;
}

/// The first step of the halving: at most half of the stability limit, and a whole part of the time between
/// checkpoints.
double firstStep(const scene::Scene& scene, const settings::Settings& settings) {
  double longest = settings.step.timeStep;
  const sim::SolverInfo* solver = sim::findSolver(settings.solver.name);
  if (solver != nullptr && solver->stepLimit != nullptr) {
    const double limit = solver->stepLimit(*scene.model, settings.step);
    longest = limit > 0.0 ? std::min(longest, 0.5 * limit) : longest;
  }
  return checkpointInterval / std::ceil(checkpointInterval / longest * (1.0 - 1e-9));
}

double toleranceAt(const ConvergenceTolerance& tolerance, const Trajectory& run, std::size_t checkpoint) {
  if (tolerance.compared == nullptr || checkpoint >= tolerance.compared->states.size()) {
    return tolerance.absolute;
  }
  const double error =
      sim::meanDistance(tolerance.compared->states[checkpoint].positions, run.states[checkpoint].positions);
  return std::max(tolerance.absolute, tolerance.share * error);
}

/// Compares the finer run with the coarser one and keeps the finer one.
void accept(Reference& reference, Trajectory finer, const ConvergenceTolerance& tolerance) {
  const Trajectory& coarser = reference.trajectory;
  const std::size_t count = std::min(coarser.states.size(), finer.states.size());
  Halving halving;
  halving.timeStep = reference.settings.step.timeStep;
  reference.differences.assign(count, 0.0);
  bool passing = true;
  for (std::size_t k = 1; k < count; ++k) {
    reference.differences[k] = sim::meanDistance(coarser.states[k].positions, finer.states[k].positions);
    halving.difference = std::max(halving.difference, reference.differences[k]);
    passing = passing && reference.differences[k] <= toleranceAt(tolerance, finer, k);
    halving.trusted = passing ? static_cast<int>(k) : halving.trusted;
  }
  reference.trusted = halving.trusted;
  reference.halvings.push_back(halving);
  reference.trajectory = std::move(finer);
}

/// Detects that the last halvings no longer improve the first failing checkpoint.
class ProgressCheck {
 public:
  [[nodiscard]] bool hasStalled(const Reference& reference) {
    const auto failing = static_cast<std::size_t>(reference.trusted) + 1;
    const double difference = failing < reference.differences.size() ? reference.differences[failing] : 0.0;
    const bool helped = failing != failing_ || difference < helpful * difference_;
    fruitless_ = helped ? 0 : fruitless_ + 1;
    failing_ = failing;
    difference_ = difference;
    return fruitless_ >= maxFruitless;
  }

 private:
  std::size_t failing_ = 0;
  double difference_ = 0.0;
  int fruitless_ = 0;
};

/// Why the halving ended.
enum class Ending { Passed, Stalled, TooExpensive };

std::string doubtAbout(const Reference& reference, Ending ending) {
  if (reference.halvings.empty() && ending == Ending::TooExpensive) {
    return fmt::format(
        "The reference would take too long: its convergence is tested by a run with half of its step of {:.3g} s. "
        "Simulate a shorter time (--seconds) or a coarser mesh.",
        reference.settings.step.timeStep);
  }
  const auto failing = static_cast<std::size_t>(reference.trusted) + 1;
  if (failing >= reference.differences.size()) {
    return blewUp(reference);
  }
  return fmt::format(
             "The reference does not converge after {}: halving its step to {:.3g} s still moved the cloth by "
             "{:.3g} mm (mean) at {}",
             timeOf(reference.trusted), reference.settings.step.timeStep, 1000.0 * reference.differences[failing],
             timeOf(reference.trusted + 1)) +
         (ending == Ending::Stalled ? ", and finer steps do not reduce this: the motion is chaotic there. "
                                    : ", and finer steps would take too long. ") +
         "Later checkpoints have no reference.";
}

double workOf(const scene::Scene& scene, double timeStep, int checkpoints) {
  return static_cast<double>(scene.model->springs.size()) * checkpoints * checkpointInterval / timeStep;
}

/// Halves the step until every checkpoint passes or another limit ends it.
Ending halve(Reference& reference, const scene::Scene& scene, int checkpoints, const ConvergenceTolerance& tolerance,
             const Watch& watch) {
  ProgressCheck progressCheck;
  for (int i = 0; reference.trusted < checkpoints; ++i) {
    const double timeStep = 0.5 * reference.settings.step.timeStep;
    if (i == tolerance.maxHalvings || workOf(scene, timeStep, checkpoints) > tolerance.maxCost) {
      return Ending::TooExpensive;
    }
    reference.settings.step.timeStep = timeStep;
    accept(reference, runTrajectory(scene, inLongSteps(scene, reference.settings), checkpoints, watch), tolerance);
    if (progressCheck.hasStalled(reference)) {
      return Ending::Stalled;
    }
  }
  return Ending::Passed;
}

}  // namespace

settings::Settings sameStepSettings(settings::Settings settings) {
  settings.solver.name = "newton";
  settings.step.iteration.tolerance = 1e-10;
  return settings;
}

settings::Settings convergedSettings(settings::Settings settings) {
  settings.solver.name = "verlet";
  settings.step.integration = sim::Integration::BackwardEuler;
  settings.step.substeps = 1;
  settings.step.precision = sim::Precision::Double;  // short steps in float would add up their rounding
  return settings;
}

Reference sameStepReference(const scene::Scene& scene, const settings::Settings& settings, int checkpoints,
                            const Progress& progress) {
  // Substeps and extrapolated steps do not satisfy the equation of the whole step.
  const bool plain = settings.step.substeps == 1 && settings.step.integration == sim::Integration::BackwardEuler;
  Reference reference = runOnce(ReferenceKind::SameStep, scene, settings, checkpoints,
                                {.energy = false, .stepResiduals = plain, .label = "reference", .progress = progress});
  if (reference.trajectory.unsolvedSteps > 0 && reference.doubt.empty()) {
    reference.doubt =
        fmt::format("{} steps of the reference did not reach its tolerance; the worst residual is {:.3g}.",
                    reference.trajectory.unsolvedSteps, reference.trajectory.largestResidual);
  }
  return reference;
}

Reference convergedReference(const scene::Scene& scene, const settings::Settings& settings, int checkpoints,
                             const ConvergenceTolerance& tolerance, const Progress& progress) {
  Watch watch;
  watch.label = "reference";
  watch.progress = progress;
  Reference reference;
  reference.kind = ReferenceKind::Converged;
  reference.settings = settings;
  reference.settings.step.timeStep = firstStep(scene, settings);
  reference.trajectory = runTrajectory(scene, inLongSteps(scene, reference.settings), checkpoints, watch);
  reference.differences.assign(reference.trajectory.states.size(), std::numeric_limits<double>::infinity());
  const Ending ending = halve(reference, scene, checkpoints, tolerance, watch);
  requireMotion(reference);
  if (ending != Ending::Passed) {
    reference.doubt = doubtAbout(reference, ending);
  }
  if (reference.trusted < 1 && !tolerance.takeAnyway) {
    throw messages::InputError(reference.doubt +
                               (reference.halvings.empty()
                                    ? ""
                                    : " Use a larger --reference-tolerance, or another solver with --reference-set"));
  }
  return reference;
}

Reference solverReference(const scene::Scene& scene, const settings::Settings& settings, int checkpoints,
                          const Progress& progress) {
  Watch watch;
  watch.label = "reference";
  watch.progress = progress;
  return runOnce(ReferenceKind::Solver, scene, settings, checkpoints, watch);
}

}  // namespace drape::report
