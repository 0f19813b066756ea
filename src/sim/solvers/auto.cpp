#include "sim/adaptive/adaptive_run.hpp"
#include "sim/adaptive/energy_guard.hpp"
#include "sim/adaptive/settling.hpp"
#include "sim/adaptive/sleep_detection.hpp"
#include "sim/adaptive/step_memory.hpp"
#include "sim/adaptive/taut_cloth.hpp"
#include "sim/adaptive/tuning.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/forces/external_forces.hpp"
#include "sim/forces/forces.hpp"
#include "sim/forces/stability.hpp"
#include "sim/model/model_cache.hpp"
#include "sim/model/pieces.hpp"
#include "sim/motion/momentum.hpp"
#include "sim/simd/convert.hpp"
#include "sim/simd/step_origin.hpp"
#include "sim/solvers/registry.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace drape::sim {
namespace {

/// Error estimates are due at the steps 0, 1, 4, 16, 64 and then at every 128th (tuning.estimateInterval).
bool estimateIsDue(int steps) {
  const auto count = static_cast<unsigned>(steps);
  return steps % adaptive::tuning.estimateInterval == 0 ||
         (std::has_single_bit(count) && std::countr_zero(count) % 2 == 0);
}

/// Whether to estimate the error of a step. If stability needs more than the budget, the estimate cannot change the
/// plan, so the first steps, which are slow anyway, are not estimated. If the tolerance needs far more than the budget,
/// the estimate can change little, so some of the first steps are not estimated.
bool estimatesError(const adaptive::StepChoice& choice, double budgetedEvaluations,
                    const adaptive::StepMemory& memory) {
  const bool unreachable = memory.steps > 0 && memory.steps < adaptive::tuning.earlyEstimateEnd &&
                           memory.forceEvaluations > adaptive::tuning.unreachableFactor * budgetedEvaluations;
  const bool useful = choice.costRatio <= adaptive::toleratedCostRatio && !unreachable;
  return estimateIsDue(memory.steps) && (useful || memory.steps >= adaptive::tuning.estimateInterval);
}

/// Whether the lift of eq. 20 acts, which AdaptiveRun limits.
bool limitsLift(const ClothModel& model, const AirParameters& air) {
  return !actsAsPlate(model, air) && air.lift > 0.0 && air.density > 0.0;
}

/// StepMemory::speed; 0 if the positions before the step are not known.
double speedBetween(const std::vector<Vec3>& before, const std::vector<Vec3>& after, double time) {
  double sum = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    sum += (after[i] - before[i]).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, before.size()))) / time;
}

/// An adaptive explicit method. In each step:
/// 1. `planStep` chooses the scheme, the substeps and the clamping of the springs, from the cloth, the cost budget and
///    the state's memory;
/// 2. AdaptiveRun takes the step;
/// 3. the energy guard compares the energy of the first and the last substep. If it grew by more than external work
///    explains, the step is retried with a safer plan, up to three times, and then taken in parts;
/// 4. some steps are also taken with twice the substeps (estimateIsDue). The difference estimates the error, which
///    gives the number of force evaluations for the tolerance. This number falls by at most a factor of two at a time.
/// Clocks are read for statistics only, and the memory is part of the state: the same arguments give the same step.
template <typename T>
class AdaptiveStep {
 public:
  /// @return nothing if the energy of a fabric grew in float: then rounding at slivers may be the cause, the state is
  /// as before, and the step should be taken in double
  std::optional<StepReport> step(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                                 const StepInputs& inputs, adaptive::StepMemory& memory, ClothState& state) {
    contactWork_ = 0.0;
    const double contactSeconds = run_.contactSeconds();
    saferPlans_ = 0;
    const adaptive::StepPlan plan = planned(model, rates, parameters, inputs, memory);
    const double budget = adaptive::evaluationsInBudget(model, parameters, parameters.automatic);
    adaptive::StepChoice choice{.order = plan.scheme == adaptive::ExplicitScheme::Pefrl ? 4 : 2,
                                .substeps = plan.substeps,
                                .hOmega = parameters.timeStep * largestFrequency(model, parameters),
                                .costRatio = plan.cost() / budget,
                                .stiffnessScale = adaptive::medianStiffnessScale(rates, parameters, plan)};
    if (plan.isImplicit) {
      takeImplicitStep(model, rates, parameters, inputs, plan, memory, state);
      countStep(memory);
      choice.order = 1;
      choice.forceEvaluations = plan.cost();
      return StepReport{.choice = choice};
    }
    memory.tautEnergy = adaptive::unknownEnergy;  // the mouse or contacts may change the energy in this step
    choice.forceEvaluations = 0;
    const bool estimating = estimatesError(choice, budget, memory);
    if (estimating) {
      takeFinerStep(model, rates, parameters, inputs, plan, state, choice);
    }
    if (!takeStep(model, rates, parameters, inputs, plan, memory, state, choice)) {
      return std::nullopt;
    }
    if (estimating && choice.retries == 0) {
      estimateError(model, parameters, plan, state, memory);
    }
    updateRetryLevel(saferPlans_, memory);
    countStep(memory);
    choice.error = memory.error;
    choice.energyDrift = memory.energyDrift;
    state.time += parameters.timeStep;
    return StepReport{
        .contactWork = contactWork_, .substepContactSeconds = run_.contactSeconds() - contactSeconds, .choice = choice};
  }

 private:
  /// The plan of the next step, which depends on the retries of earlier ones.
  static adaptive::StepPlan planned(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                                    const StepInputs& inputs, const adaptive::StepMemory& memory) {
    adaptive::StepPlan plan = adaptive::planStep(model, rates, parameters, parameters.automatic, inputs, memory);
    for (int i = 0; i < memory.retryLevel && !plan.isImplicit; ++i) {
      plan = adaptive::saferPlan(plan);
    }
    plan.substeps *= parameters.automatic.refinement;
    plan.fullLift = parameters.automatic.fullLift;
    return plan;
  }

  /// @return whether the step was taken
  bool takeStep(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                const StepInputs& inputs, adaptive::StepPlan plan, adaptive::StepMemory& memory, ClothState& state,
                adaptive::StepChoice& choice) {
    guard_.prepare(model, rates, parameters, state, 0.5 * static_cast<double>(std::numeric_limits<T>::epsilon()),
                   simd::stepOrigin<T>(state.positions));
    adaptive::StepPlan first = plan;
    while (saferPlans_ <= adaptive::tuning.maxRetries) {
      checkStop(inputs);
      const bool isRetry = choice.retries > 0;
      const bool startIsKnown = guard_.isStartEnergyKnown(plan, memory);
      const bool measuring = isRetry || inputs.attachment || guard_.isMeasurementDue(plan, memory);
      adaptive::StepEnergy energy =
          run_.run(model, rates, parameters, inputs, plan, state, {measuring && !startIsKnown, measuring});
      energy.start = startIsKnown ? memory.energy : energy.start;
      energy.visibleStart = startIsKnown ? memory.visibleEnergy : energy.visibleStart;
      const double work = windWork(model, rates, parameters, inputs, state) + attachmentWork(model, inputs, state) +
                          pinWork(model, parameters, inputs, state);
      choice.forceEvaluations += plan.cost();
      choice.coarseLevels = run_.levels();
      if (plan.usesCoarseLevels && guard_.levelsStoreTooMuch(model, state, energy.levels, memory.withoutLevels == 0)) {
        memory.withoutLevels = adaptive::tuning.calmSteps + 1;
        first = plan = planned(model, rates, parameters, inputs, memory);
        choice.substeps = plan.substeps;
        choice.stiffnessScale = adaptive::medianStiffnessScale(rates, parameters, plan);
        ++choice.retries;
        continue;
      }
      if (!guard_.hasGrown(energy, work, isRetry, memory)) {
        before_ = state.positions;
        run_.store(state);
        run_.storeContacts(inputs);
        contactWork_ = energy.contactWork;
        memory.speed = speedBetween(before_, state.positions, parameters.timeStep);
        guard_.store(model, parameters, plan, energy, work, memory, state);
        return true;
      }
      if (plan.bendingInterval > 1 || plan.airInterval > 1) {
        // Forces that act in one of several substeps can be in resonance with the membrane.
        plan.bendingInterval = plan.airInterval = 1;
        memory.everySubstep = adaptive::tuning.everySubstepSteps;
        ++choice.retries;
        continue;
      }
      if (std::is_same_v<T, float> && model.fabric) {
        return false;
      }
      ++choice.retries;
      ++saferPlans_;
      plan = adaptive::saferPlan(plan);
      choice.order = 2;
      choice.substeps = plan.substeps;
      choice.stiffnessScale = adaptive::medianStiffnessScale(rates, parameters, plan);
    }
    takeStepInParts(model, rates, parameters, inputs, first, memory, state, choice);
    memory.schemeEnergyDrift = 0.0;
    return true;
  }

  /// Takes the step in equal parts, with as many substeps as each part needs. The violent moment of a start is short,
  /// so few parts need many. A part that needs too many is taken by the fallback solver.
  void takeStepInParts(const ClothModel& model, const LocalRates& rates, StepParameters parameters,
                       const StepInputs& inputs, adaptive::StepPlan plan, adaptive::StepMemory& memory,
                       ClothState& state, adaptive::StepChoice& choice) {
    constexpr int parts = adaptive::tuning.partsOfStep;
    const double time = state.time;
    StepInputs ofParts = inputs;
    ofParts.contacts = nullptr;
    ofParts.movedPins = nullptr;
    if (inputs.movedPins != nullptr) {
      movePinsBy(*inputs.movedPins, 1.0, state);  // at once, since the parts do not follow their path
    }
    parameters.timeStep /= parts;
    plan.substeps = (plan.forceEvaluations() + parts - 1) / parts;
    plan.scheme = adaptive::ExplicitScheme::Verlet;
    plan.airInterval = plan.bendingInterval = 1;
    choice.order = 2;
    choice.substeps = 0;
    choice.inParts = true;
    adaptive::StepMemory ofPart;
    ofPart.energyDrift = memory.energyDrift;
    for (int i = 0; i < parts; ++i) {
      if (!takePart(model, rates, parameters, ofParts, plan, ofPart, state, choice)) {
        takeFallbackStep(model, rates, parameters, ofParts, state, choice);
      }
    }
    memory.energyDrift = ofPart.energyDrift;
    state.time = time;
  }

  /// @return whether the part was taken
  bool takePart(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                const StepInputs& inputs, adaptive::StepPlan plan, adaptive::StepMemory& memory, ClothState& state,
                adaptive::StepChoice& choice) {
    guard_.prepare(model, rates, parameters, state, 0.5 * static_cast<double>(std::numeric_limits<T>::epsilon()),
                   simd::stepOrigin<T>(state.positions));
    const double largestCost = adaptive::maxEvaluations(model, parameters, parameters.automatic);
    for (int retry = 0; retry <= adaptive::tuning.maxRetriesOfPart && plan.cost() <= largestCost; ++retry) {
      checkStop(inputs);
      const adaptive::StepEnergy energy = run_.run(model, rates, parameters, inputs, plan, state, {true, true});
      const double work = windWork(model, rates, parameters, inputs, state) + attachmentWork(model, inputs, state);
      choice.forceEvaluations += plan.cost();
      if (!guard_.hasGrown(energy, work, retry > 0, memory)) {
        run_.store(state);
        guard_.store(model, parameters, plan, energy, work, memory, state);
        choice.substeps += plan.substeps;
        return true;
      }
      plan = adaptive::saferPlan(plan);
    }
    return false;
  }

  /// Takes a step of taut cloth with the solver `one_iteration`. Its single iteration can add energy. What exceeds the
  /// energy at the first of these steps is removed from the motion. The work of pins is not known. So after they moved,
  /// and after explicit steps, the energy is measured again.
  void takeImplicitStep(const ClothModel& model, const LocalRates& rates, StepParameters parameters,
                        const StepInputs& inputs, const adaptive::StepPlan& plan, adaptive::StepMemory& memory,
                        ClothState& state) {
    if (!implicit_) {
      implicit_ = solvers::oneIteration().make();
    }
    if (memory.tautEnergy == adaptive::unknownEnergy) {
      memory.tautEnergy = energyOf(model, parameters, state).total();
    }
    const double timeStep = parameters.timeStep;
    const double end = state.time + timeStep;
    before_ = state.positions;
    parameters.timeStep /= plan.substeps;
    parameters.precision = std::is_same_v<T, float> ? Precision::Float : Precision::Double;
    parameters.integration = Integration::BackwardEuler;
    parameters.jacobi = {};
    if (inputs.movedPins == nullptr) {
      implicit_->steps(model, parameters, inputs, plan.substeps, state);
      memory.tautEnergy += adaptive::maxWindWork(rates, parameters) * plan.substeps;
      limitTautEnergy(model, rates, parameters, memory, state);
    } else {
      takeImplicitSubsteps(model, parameters, inputs, plan.substeps, state);
      memory.tautEnergy = adaptive::unknownEnergy;
    }
    state.time = end;
    memory.speed = speedBetween(before_, state.positions, timeStep);
    memory.fingerprint = memory.planFingerprint = 0;  // the energy guard knows nothing about this step
  }

  /// Substeps in which the pins move by equal parts of their way.
  void takeImplicitSubsteps(const ClothModel& model, const StepParameters& parameters, StepInputs inputs, int substeps,
                            ClothState& state) {
    const std::vector<MovedPin>& pins = *inputs.movedPins;
    inputs.movedPins = nullptr;
    for (int i = 0; i < substeps; ++i) {
      movePinsBy(pins, 1.0 / substeps, state);
      implicit_->step(model, parameters, inputs, state);
    }
  }

  /// The energy costs as much as a substep, so it is not measured in each step.
  void limitTautEnergy(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                       const adaptive::StepMemory& memory, ClothState& state) {
    if (memory.steps % adaptive::tuning.tautEnergySteps == 0) {
      const double drift = adaptive::tuning.maxEnergyDrift * parameters.gravity * rates.mass * rates.diagonal;
      adaptive::removeInnerMotion(model, pieces_.get(model, freePieces),
                                  energyOf(model, parameters, state).total() - memory.tautEnergy - drift, state);
    }
  }

  static void countStep(adaptive::StepMemory& memory) {
    memory.everySubstep = std::max(0, memory.everySubstep - 1);
    memory.withoutLevels = std::max(0, memory.withoutLevels - 1);
    memory.steps += 1;
    if (memory.steps == 2 * adaptive::tuning.estimateInterval) {
      memory.steps = adaptive::tuning.estimateInterval;
    }
  }

  /// After a retry with a safer plan the next steps start with one. The retry level falls again after some calm steps.
  static void updateRetryLevel(int saferPlans, adaptive::StepMemory& memory) {
    if (saferPlans > 0) {
      memory.retryLevel = std::min(memory.retryLevel + saferPlans, adaptive::tuning.maxRetryLevel);
      memory.calmSteps = 0;
    } else if (memory.retryLevel > 0 && ++memory.calmSteps == adaptive::tuning.calmSteps) {
      --memory.retryLevel;
      memory.calmSteps = 0;
    }
  }

  /// An upper bound of the work of the wind in the last step [J]. In the frame of the wind, air only takes energy. So
  /// its work on free cloth is at most the wind's velocity times the impulse of the air, which is the change of
  /// momentum less that by gravity. Pins, contacts and an attachment change the momentum too; then the bound is
  /// maxWindWork.
  [[nodiscard]] double windWork(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                                const StepInputs& inputs, const ClothState& state) {
    const double largest = adaptive::maxWindWork(rates, parameters);
    if (largest == 0.0 || rates.pinnedLength > 0.0 || inputs.contacts != nullptr || inputs.attachment) {
      return largest;
    }
    after_ = state;
    run_.store(after_);
    Vec3 impulse = Vec3::Zero();
    for (std::size_t v = 0; v < state.velocities.size(); ++v) {
      impulse += model.vertexMass[v] * (after_.velocities[v] - state.velocities[v]);
    }
    impulse.y() += rates.mass * parameters.gravity * parameters.timeStep;
    return std::min(largest, parameters.air.wind.dot(impulse));
  }

  /// An upper bound of the work of the attachment in the last step [J].
  [[nodiscard]] double attachmentWork(const ClothModel& model, const StepInputs& inputs, const ClothState& state) {
    if (!inputs.attachment) {
      return 0.0;
    }
    after_ = state;
    run_.store(after_);
    const AttachedCorners corners = attachedCorners(model, *inputs.attachment);
    return inputs.attachment->maxForce * attachedPointMotion(corners, state, after_).norm();
  }

  /// An upper bound of the work of moving pins in the last step [J]: the work of the larger one of the forces at the
  /// two ends of the step, plus that of the force m omega v / 2 with which a row of vertices resists a sudden velocity
  /// v.
  [[nodiscard]] double pinWork(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                               const ClothState& state) {
    if (inputs.movedPins == nullptr) {
      return 0.0;
    }
    after_ = state;
    run_.store(after_);
    movePinsBy(*inputs.movedPins, 1.0, after_);
    double work = 0.0;
    const double rate = 0.5 * largestFrequency(model, parameters) / parameters.timeStep;
    for (const MovedPin& pin : *inputs.movedPins) {
      const auto v = static_cast<std::size_t>(pin.vertex);
      const double first = -pin.by.dot(internalForceOn(model, parameters, state, v));
      const double last = -pin.by.dot(internalForceOn(model, parameters, after_, v));
      work += std::max(first, last) + rate * model.vertexMass[v] * pin.by.squaredNorm();
    }
    return work;
  }

  /// @param part of their way [-]
  static void movePinsBy(const std::vector<MovedPin>& pins, double part, ClothState& state) {
    for (const MovedPin& pin : pins) {
      state.positions[static_cast<std::size_t>(pin.vertex)] += part * pin.by;
    }
  }

  /// Takes a part of a step with the fallback solver, which must be unconditionally stable. With few iterations it
  /// leaves springs stretched; the elastic energy that this adds is removed from the motion. The energy counts the full
  /// stiffness.
  void takeFallbackStep(const ClothModel& model, const LocalRates& rates, StepParameters parameters,
                        const StepInputs& inputs, ClothState& state, adaptive::StepChoice& choice) {
    std::unique_ptr<Solver>& fallback = model.fabric ? fabricFallback_ : springFallback_;
    if (!fallback) {
      fallback = model.fabric ? solvers::newton().make() : solvers::xpbd().make();
    }
    const double allowed = energyOf(model, parameters, state).total() + adaptive::maxWindWork(rates, parameters) +
                           (inputs.attachment ? inputs.attachment->maxForce * parameters.timeStep : 0.0);
    parameters.precision = Precision::Double;
    choice.forceEvaluations += parameters.iteration.iterations;
    choice.substeps += 1;
    choice.order = 1;
    choice.usedFallback = true;
    momentum_.prepare(model, parameters, inputs, state);
    fallback->step(model, parameters, inputs, state);
    momentum_.correct(model, parameters.timeStep, parameters.timeStep, state);
    adaptive::removeInnerMotion(model, pieces_.get(model, freePieces),
                                energyOf(model, parameters, state).total() - allowed, state);
  }

  /// Takes the same step with twice the substeps, into `finer_`.
  void takeFinerStep(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                     const StepInputs& inputs, adaptive::StepPlan plan, const ClothState& state,
                     adaptive::StepChoice& choice) {
    plan.substeps *= 2;
    run_.run(model, rates, parameters, inputs, plan, state, {});
    choice.forceEvaluations += plan.cost();
    finer_ = state;
    run_.store(finer_);
  }

  /// Estimates the error after `errorTime`, as if the errors of all steps added up, and the force evaluations that the
  /// tolerance needs. The difference is averaged over neighbours first. That removes short fast vibrations, whose phase
  /// is wrong at any affordable step, and rounding; neither displaces the cloth as a whole.
  void estimateError(const ClothModel& model, const StepParameters& parameters, const adaptive::StepPlan& plan,
                     const ClothState& state, adaptive::StepMemory& memory) {
    std::vector<Vec3>& difference = finer_.positions;
    for (std::size_t i = 0; i < difference.size(); ++i) {
      difference[i] -= state.positions[i];
    }
    for (int ring = 0; ring < adaptive::tuning.errorSmoothingRings; ++ring) {
      averageOverRings(model, difference);
    }
    double sum = 0.0;
    for (const Vec3& each : difference) {
      sum += each.norm();
    }
    const double order = plan.scheme == adaptive::ExplicitScheme::Pefrl ? 4.0 : 2.0;
    const double extrapolation = 1.0 / (1.0 - std::exp2(-order));  // from the difference to the error (Richardson)
    const double error =
        extrapolation * adaptive::errorTime / parameters.timeStep * sum / static_cast<double>(state.positions.size());
    if (!std::isfinite(error)) {
      return;
    }
    const double evaluations = plan.cost() * std::pow(error / parameters.automatic.errorTolerance, 1.0 / order);
    memory.error = error;
    memory.forceEvaluations = std::max({1.0, adaptive::tuning.maxDecrease * plan.cost(), evaluations});
  }

  /// Replaces each value by the mean of itself and its neighbours.
  void averageOverRings(const ClothModel& model, std::vector<Vec3>& values) {
    averaged_.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      Vec3 sum = values[i];
      const std::span<const SpringEnd> ends = model.springEnds[i];
      for (const SpringEnd& end : ends) {
        sum += values[end.neighbour];
      }
      averaged_[i] = sum / (1.0 + static_cast<double>(ends.size()));
    }
    values.swap(averaged_);
  }

  adaptive::AdaptiveRun<T> run_;
  adaptive::EnergyGuard guard_;
  std::unique_ptr<Solver> springFallback_;
  std::unique_ptr<Solver> fabricFallback_;
  std::unique_ptr<Solver> implicit_;
  MomentumKeeper momentum_;
  ModelCache<std::vector<std::vector<std::size_t>>> pieces_;
  ClothState finer_;
  ClothState after_;
  std::vector<Vec3> before_;  // positions at the start of the step
  std::vector<Vec3> averaged_;
  double contactWork_ = 0.0;  // of the last step [J]
  int saferPlans_ = 0;        // retries of the step with a safer plan
};

class AutoSolver final : public Solver {
 public:
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) override {
    adaptive::StepMemory memory = adaptive::stepMemoryOf(state);
    const StepReport report = step(model, parameters, inputs, memory, state);
    adaptive::storeStepMemory(std::move(memory), state);
    return report;
  }

  bool sleeps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
              const ClothState& state) override {
    return sleep_.staysAsleep(model, conditionsOf(parameters, inputs), adaptive::stepMemoryOf(state), state);
  }

 private:
  static adaptive::SleepConditions conditionsOf(const StepParameters& parameters, const StepInputs& inputs) {
    return {parameters, parameters.contact, inputs, parameters.automatic.errorTolerance};
  }

  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  adaptive::StepMemory& memory, ClothState& state) {
    if (sleep_.isAsleep(model, conditionsOf(parameters, inputs), memory, state)) {
      state.time += parameters.timeStep;
      return {.choice = adaptive::StepChoice{.substeps = 0, .forceEvaluations = 0, .sleeping = true}};
    }
    const double settlingWork = adaptive::settle(model, conditionsOf(parameters, inputs), memory, state);
    StepReport report = stepAwake(model, parameters, inputs, memory, state);
    report.settlingWork = settlingWork;
    return report;
  }

  StepReport stepAwake(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                       adaptive::StepMemory& memory, ClothState& state) {
    const LocalRates& rates = rates_.get(model, localRatesOf);
    updateTautness(model, rates, parameters, inputs, memory, state);
    const DoubleReason reason = reasonForDouble(model, rates, parameters, inputs, memory, state);
    const bool startsInFloat = reason == DoubleReason::None;
    if (startsInFloat) {
      const adaptive::StepMemory before = memory;
      if (const std::optional<StepReport> report = single_.step(model, rates, parameters, inputs, memory, state)) {
        return *report;
      }
      const int everySubstep = memory.everySubstep;
      memory = before;
      memory.everySubstep = everySubstep;
      memory.doubleSteps = adaptive::tuning.doubleSteps;
    }
    memory.doubleSteps = std::max(0, memory.doubleSteps - 1);
    StepParameters affordable = parameters;
    affordable.automatic.costBudget /= reason == DoubleReason::Tolerance ? adaptive::tuning.doubleCost : 1.0;
    StepReport report = *double_.step(model, rates, affordable, inputs, memory, state);
    if (startsInFloat && report.choice->retries > 0) {
      memory.doubleSteps = 0;  // the energy grew in double, too, so rounding is not the cause
    }
    return report;
  }

  /// Tests whether the cloth is taut where its springs would be softened, and again after pins or settings changed.
  void updateTautness(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                      const StepInputs& inputs, adaptive::StepMemory& memory, const ClothState& state) {
    memory.tautSteps = std::max(0, memory.tautSteps - 1);
    if (limitsLift(model, parameters.air)) {
      memory.taut = false;  // the solver one_iteration does not limit it
      memory.tautFingerprint = 0;
      return;
    }
    if (memory.tautSteps > 0 || !adaptive::maySoften(model, parameters, parameters.automatic)) {
      return;
    }
    const adaptive::StepPlan plan = adaptive::planStep(model, rates, parameters, parameters.automatic, inputs, memory);
    if (!plan.softens && !plan.isImplicit) {
      return;
    }
    const std::uint64_t fingerprint = tautFingerprint(model, parameters, state);
    if (fingerprint != memory.tautFingerprint) {
      memory.taut =
          adaptive::isTaut(model, levels_.get(model, adaptive::buildCoarseLevels), parameters, state.positions);
      memory.tautFingerprint = fingerprint;
      memory.tautEnergy = adaptive::unknownEnergy;
      memory.tautSteps = adaptive::tuning.tautSteps;
    }
  }

  /// The fingerprint of what decides whether a cloth is taut, apart from its shape.
  static std::uint64_t tautFingerprint(const ClothModel& model, const StepParameters& parameters,
                                       const ClothState& state) {
    std::uint64_t sum = std::bit_cast<std::uint64_t>(parameters.material.stiffness) +
                        3 * std::bit_cast<std::uint64_t>(parameters.gravity);
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
      if (model.pinned[v]) {
        sum += simd::sumOfBits(state.positions[v].data(), 3) * (2 * v + 1);
      }
    }
    return sum;
  }

  /// Why a step is taken in double: it must be, or it is more accurate for the same cost.
  enum class DoubleReason { None, Required, Tolerance };

  /// While contacts act, rounding does not count as an error: contact corrects positions by more than that.
  static DoubleReason reasonForDouble(const ClothModel& model, const LocalRates& rates,
                                      const StepParameters& parameters, const StepInputs& inputs,
                                      const adaptive::StepMemory& memory, const ClothState& state) {
    if (parameters.precision == Precision::Double || memory.doubleSteps > 0 ||
        adaptive::dampingNeedsDouble(rates, parameters)) {
      return DoubleReason::Required;
    }
    const double largest = adaptive::maxCoordinate(state.positions, simd::stepOrigin<float>(state.positions));
    if (adaptive::roundingAddsEnergy(model, rates, parameters, parameters.automatic, memory, largest,
                                     inputs.contacts != nullptr)) {
      return DoubleReason::Required;
    }
    return inputs.contacts == nullptr && adaptive::roundingExceedsTolerance(
                                             model, rates, parameters, parameters.automatic, inputs, memory, largest)
               ? DoubleReason::Tolerance
               : DoubleReason::None;
  }

  adaptive::SleepDetection sleep_;
  ModelCache<std::vector<adaptive::CoarseLevel>> levels_;
  ModelCache<LocalRates> rates_;
  AdaptiveStep<float> single_;
  AdaptiveStep<double> double_;
};

/// Warns if the cost budget is too small for this cloth, and says whether speed or stiffness suffers.
std::optional<SolverWarning> costWarning(const ClothModel& model, const StepParameters& parameters) {
  const double frequency = largestFrequency(model, parameters);
  const double evaluations = adaptive::evaluationsInBudget(model, parameters, parameters.automatic);
  const double hOmega = std::max(frequency * parameters.timeStep, 1e-30);
  if (adaptive::toleratedCostRatio * evaluations * 2.0 >= hOmega) {
    return std::nullopt;
  }
  if (model.fabric) {
    // With a limit on strain the stiffness follows from the motion (StretchChoice), and so does the cost.
    return parameters.automatic.strainLimit > 0.0
               ? std::nullopt
               : std::optional(
                     SolverWarning{.kind = SolverWarning::Kind::SlowFabric, .costRatio = 0.5 * hOmega / evaluations});
  }
  const double cost =
      parameters.automatic.soften ? evaluations : adaptive::maxEvaluations(model, parameters, parameters.automatic);
  const double withLevels = std::max(adaptive::tuning.minEvaluations, std::floor(cost / adaptive::costWithLevels));
  if (!adaptive::maySoften(model, parameters, parameters.automatic) ||
      adaptive::isHardlySlowerThanLevels(0.5 * hOmega, withLevels)) {
    return SolverWarning{.kind = SolverWarning::Kind::SlowMotion, .costRatio = 0.5 * hOmega / evaluations};
  }
  const double clamped = withLevels * adaptive::tuning.clampHOmega / hOmega;
  return SolverWarning{.kind = SolverWarning::Kind::Softened,
                       .stiffnessScale = clamped * clamped,
                       .neededCost = std::ceil(0.5 * frequency * static_cast<double>(model.springs.size()) * 1e-6),
                       .softenedByChoice = parameters.automatic.soften};
}

/// The most important warning, if there are any.
std::optional<SolverWarning> autoWarning(const ClothModel& model, const StepParameters& parameters) {
  std::optional<SolverWarning> warning = costWarning(model, parameters);
  if (!warning && limitsLift(model, parameters.air)) {
    warning = SolverWarning{.kind = SolverWarning::Kind::LimitedLift};
  }
  return warning;
}

}  // namespace

SolverInfo solvers::adaptive() {
  return {.name = "auto",
          .title = "Auto",
          .help =
              "Adaptive explicit integration of second or fourth order. It chooses the number of substeps from the "
              "cloth and the error tolerance. An energy guard retries unstable steps. If the cost budget is too small "
              "for a stiff and fine cloth, the simulation runs in slow motion. With auto.soften it runs in real time "
              "with softer springs, and coarse levels carry the tension. A message tells which.",
          .source = "Drape (docs/theory/auto.md), on Stoermer-Verlet and Omelyan, Mryglod and Folk, 2002",
          .backwardEuler = false,
          .takesFabric = true,
          .choosesSubsteps = true,
          .resolvesContacts = true,
          .settings = {"precision", "auto.cost", "auto.soften", "auto.budget", "auto.tolerance"},
          .warning = autoWarning,
          .stepLimit = nullptr,
          .make = []() -> std::unique_ptr<Solver> { return std::make_unique<AutoSolver>(); }};
}

}  // namespace drape::sim
