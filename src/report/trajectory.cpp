#include "report/trajectory.hpp"

#include "messages/error.hpp"
#include "settings/settings_table.hpp"
#include "sim/contact/bodies/world.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/measures/residuals.hpp"
#include "sim/stepping/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace drape::report {
namespace {

/// Advances a cloth from checkpoint to checkpoint and records the results.
class Runner {
 public:
  Runner(const scene::Scene& scene, const settings::Settings& settings, int checkpoints, const Watch& watch)
      : model_(*scene.model),
        parameters_(settings.step),
        watch_(watch),
        stepper_(settings.solver.name),
        bodies_(scene.bodies, scene.start.time),
        stepsTotal_(static_cast<std::int64_t>(checkpoints) * stepsPerCheckpoint(settings.step.timeStep)) {
    stepper_.keepContactWork(watch.energy);
    trajectory_.stepsPerCheckpoint = stepsPerCheckpoint(settings.step.timeStep);
    if (watch.energyPeak) {
      trajectory_.largestEnergy = sim::energyOf(model_, parameters_, scene.start).total();
    }
    record(scene.start);
  }

  /// Advances `state` to the next checkpoint and records it. False when it blew up.
  bool advance(sim::ClothState& state) {
    bodies_.reset(state.time);
    for (int i = 0; i < trajectory_.stepsPerCheckpoint; ++i) {
      step(state);
    }
    if (!sim::isFinite(state)) {
      trajectory_.finite = false;
      return false;
    }
    record(state);
    return true;
  }

  void forgetBalance() { balance_ = {}; }

  [[nodiscard]] Trajectory take() { return std::move(trajectory_); }

 private:
  void step(sim::ClothState& state) {
    const bool compare = watch_.energy || watch_.stepResiduals;
    if (compare) {
      before_ = state;
    }
    bodies_.advance(state.time, parameters_.timeStep);
    sim::StepInputs inputs;
    inputs.bodies = &bodies_.steps();
    inputs.onProgress = watch_.progress ? &reportProgress_ : nullptr;
    const sim::StepReport report = stepper_.step(model_, parameters_, inputs, state);
    trajectory_.unsolvedSteps += report.converged ? 0 : 1;
    trajectory_.largestResidual = std::max(trajectory_.largestResidual, report.residual);
    if (watch_.energy) {
      balance_.add(model_, parameters_, inputs, before_, state, stepper_.contact().unresolved(),
                   {.earlierContact = stepper_.earlierContactWork(),
                    .damping = stepper_.dampingWork(),
                    .unsteadyAir = stepper_.unsteadyAirWork()});
    }
    if (watch_.energyPeak) {
      const double energy = sim::energyOf(model_, parameters_, state).total();
      // This form of the comparison keeps NaN.
      trajectory_.largestEnergy = energy <= trajectory_.largestEnergy ? trajectory_.largestEnergy : energy;
    }
    if (watch_.stepResiduals) {
      trajectory_.largestStepResidual =
          std::max(trajectory_.largestStepResidual, sim::nonlinearResidual(model_, parameters_, {}, before_, state));
    }
    if (watch_.progress) {
      ++stepsDone_;
      reportProgress_();
    }
  }

  void record(const sim::ClothState& state) {
    trajectory_.states.push_back(state);
    trajectory_.states.back().history = {};
    if (watch_.energy) {
      trajectory_.balances.push_back(balance_);
    }
  }

  const sim::ClothModel& model_;
  sim::StepParameters parameters_;
  const Watch& watch_;
  sim::Stepper stepper_;
  sim::contact::BodyWorld bodies_;
  std::int64_t stepsDone_ = 0;
  std::int64_t stepsTotal_;
  std::function<void()> reportProgress_ = [this] { watch_.progress(watch_.label, stepsDone_, stepsTotal_); };
  sim::EnergyBalance balance_;
  sim::ClothState before_;
  Trajectory trajectory_;
};

std::string stepText(int steps) {
  return "1/" + std::to_string(30 * steps) + " s";
}

}  // namespace

int stepsPerCheckpoint(double timeStep) {
  constexpr double rounding = 1e-6;
  const double steps = checkpointInterval / timeStep;
  const double whole = std::round(steps);
  if (whole >= 1.0 && std::abs(steps - whole) <= rounding * whole) {
    return static_cast<int>(whole);
  }
  const int fewer = static_cast<int>(std::floor(steps));
  throw messages::UsageError("measuring needs a time_step that divides 1/30 s, the time between two checkpoints; " +
                             settings::formatValue(timeStep) + " s does not: use " +
                             (fewer < 1 ? "" : stepText(fewer) + " or ") + stepText(fewer + 1));
}

int checkpointsIn(double seconds) {
  const double count = std::round(seconds / checkpointInterval);
  if (!(count >= 1.0)) {
    throw messages::UsageError("measuring needs at least 1/30 s, the time between two checkpoints; " +
                               settings::formatValue(seconds) + " s is less");
  }
  return static_cast<int>(count);
}

Trajectory runTrajectory(const scene::Scene& scene, const settings::Settings& settings, int checkpoints,
                         const Watch& watch) {
  Runner runner(scene, settings, checkpoints, watch);
  sim::ClothState state = scene.start;
  for (int k = 0; k < checkpoints && runner.advance(state); ++k) {
  }
  return runner.take();
}

Trajectory runRestarted(const scene::Scene& scene, const settings::Settings& settings, const Trajectory& reference,
                        const Watch& watch) {
  const int checkpoints = reference.checkpoints();
  Runner runner(scene, settings, checkpoints, watch);
  bool finite = true;
  for (int k = 0; k < checkpoints && finite; ++k) {
    sim::ClothState state = reference.states[k];
    runner.forgetBalance();
    finite = runner.advance(state);
  }
  Trajectory trajectory = runner.take();
  trajectory.restarted = true;
  return trajectory;
}

}  // namespace drape::report
