#include "sim/adaptive/adaptive_run.hpp"
#include "sim/adaptive/energy_guard.hpp"
#include "sim/adaptive/rest_watch.hpp"
#include "sim/diagnostics.hpp"
#include "sim/model_cache.hpp"
#include "sim/momentum.hpp"
#include "sim/pieces.hpp"
#include "sim/solvers/registry.hpp"
#include "sim/stability.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace drape {
namespace {

/// How often the energy guard has a step taken again, each time with twice the substeps, before XPBD takes it.
constexpr int mostRetakes = 3;
/// No step begins with more than so many of them: the last resort is tried last.
constexpr int mostCaution = 2;
/// Error estimates come at the steps 0, 1, 4, 16, 64 and then at every 128th.
constexpr int estimateEvery = 128;

bool estimateIsDue(int steps) {
  const auto count = static_cast<unsigned>(steps);
  return steps % estimateEvery == 0 || (std::has_single_bit(count) && std::countr_zero(count) % 2 == 0);
}

/// Whether a step's error is estimated. Where a step takes what it needs in any case, there is nothing to choose, and
/// the first ones are slow enough; where the tolerance asks for far more than the work allowed, there is little.
bool estimates(const StepChoice& choice, double passesAllowed, const StepMemory& memory) {
  constexpr double outOfReach = 4.0;
  constexpr int soon = 16;
  const bool early = memory.steps > 0 && memory.steps < soon && memory.passes > outOfReach * passesAllowed;
  const bool open = choice.demand <= stretchedBudget && !early;
  return estimateIsDue(memory.steps) && (open || memory.steps >= estimateEvery);
}

/// A method that chooses for itself. In each step:
/// 1. `planStep` chooses scheme, substeps and what the springs keep, from the cloth, the budget and what was learnt;
/// 2. the step is taken (AdaptiveRun);
/// 3. the energy guard looks at the energy of the first and the last substep. Where it grew and nothing did work, the
///    step is taken again with twice the substeps, up to three times, and then by XPBD, which cannot explode;
/// 4. now and then the step is taken a second time with twice the substeps. What differs is the error of the first,
///    and says how many substeps the tolerance asks for; they change by at most a factor of two at a time downwards.
/// Nothing here looks at a clock, and what was learnt is in the state: the same arguments give the same step.
template <typename T>
class AdaptiveStep {
 public:
  StepReport step(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                  const StepInputs& inputs, ClothState& state) {
    StepPlan plan = planStep(model, rates, parameters, inputs, state.memory);
    for (int i = 0; i < state.memory.caution; ++i) {
      plan = saferThan(plan);
    }
    StepChoice choice{.order = plan.scheme == ExplicitScheme::Pefrl ? 4 : 2,
                      .substeps = plan.substeps,
                      .hardness = parameters.timeStep * largestFrequency(model, parameters),
                      .demand = plan.cost() / passesInBudget(model, parameters),
                      .stiffness = medianShare(rates, parameters, plan)};
    choice.passes = 0;
    const bool estimating = estimates(choice, passesInBudget(model, parameters), state.memory);
    if (estimating) {
      takeFiner(model, rates, parameters, inputs, plan, state, choice);
    }
    take(model, rates, parameters, inputs, plan, state, choice);
    if (estimating && choice.retaken == 0) {
      learn(model, parameters, plan, state);
    }
    remember(choice, state.memory);
    state.memory.steps += 1;
    if (state.memory.steps == 2 * estimateEvery) {
      state.memory.steps = estimateEvery;
    }
    choice.error = state.memory.error;
    choice.gained = state.memory.risen;
    state.time += parameters.timeStep;
    return {.choice = choice};
  }

 private:
  void take(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
            const StepInputs& inputs, StepPlan plan, ClothState& state, StepChoice& choice) {
    guard_.begin(model, rates, parameters, state, 0.5 * static_cast<double>(std::numeric_limits<T>::epsilon()));
    for (int retake = 0; retake <= mostRetakes; ++retake) {
      if (inputs.mayStop != nullptr) {
        (*inputs.mayStop)();
      }
      const bool startIsKnown = guard_.knowsStart(plan, state.memory);
      const bool looking = retake > 0 || inputs.attachment || guard_.isDue(plan, state.memory);
      StepEnergy energy = run_.run(model, rates, parameters, inputs, plan, state, {looking && !startIsKnown, looking});
      energy.start = startIsKnown ? state.memory.energy : energy.start;
      const double work = mostWorkOfWind(rates, parameters) + attachmentWork(model, inputs, state);
      choice.passes += plan.cost();
      choice.levels = run_.levels();
      if (!guard_.grew(energy, work, retake > 0, state.memory)) {
        run_.store(state);
        guard_.book(model, parameters, plan, energy, work, state);
        return;
      }
      ++choice.retaken;
      plan = saferThan(plan);
      choice.order = 2;
      choice.substeps = plan.substeps;
      choice.stiffness = medianShare(rates, parameters, plan);
    }
    takeLastResort(model, rates, parameters, inputs, state, choice);
  }

  /// What had to be taken again will have to be again: the steps that follow begin with what held. That wears off.
  static void remember(const StepChoice& choice, StepMemory& memory) {
    constexpr int untilCalm = 16;
    if (choice.retaken > 0) {
      memory.caution = std::min(memory.caution + choice.retaken, mostCaution);
      memory.calm = 0;
    } else if (memory.caution > 0 && ++memory.calm == untilCalm) {
      --memory.caution;
      memory.calm = 0;
    }
  }

  /// The most that the hand has done in the step that was run last [J].
  [[nodiscard]] double attachmentWork(const ClothModel& model, const StepInputs& inputs, const ClothState& state) {
    if (!inputs.attachment) {
      return 0.0;
    }
    after_ = state;
    run_.store(after_);
    Vec3 motion = Vec3::Zero();
    const Triangle& corners = model.triangles[static_cast<std::size_t>(inputs.attachment->triangle)];
    for (std::size_t c = 0; c < 3; ++c) {
      const auto v = static_cast<std::size_t>(corners[c]);
      motion +=
          inputs.attachment->barycentric[static_cast<Eigen::Index>(c)] * (after_.positions[v] - state.positions[v]);
    }
    return inputs.attachment->maxForce * motion.norm();
  }

  /// By XPBD, which cannot explode; what energy it makes, by a cloth that its few iterations leave stretched, is taken
  /// out of the motion. The energy is that of the springs with all their stiffness.
  void takeLastResort(const ClothModel& model, const LocalRates& rates, StepParameters parameters,
                      const StepInputs& inputs, ClothState& state, StepChoice& choice) {
    constexpr int substeps = 8;
    if (!lastResort_) {
      lastResort_ = findSolver("xpbd")->make();
    }
    const double time = state.time;
    const double allowed = energyOf(model, parameters, state).total() + mostWorkOfWind(rates, parameters) +
                           (inputs.attachment ? inputs.attachment->maxForce * parameters.timeStep : 0.0);
    parameters.precision = Precision::Double;
    parameters.timeStep /= substeps;
    choice.passes += substeps * parameters.iterations;
    choice.substeps = substeps;
    choice.order = 1;
    choice.stiffness = 1.0;
    choice.levels = 0;
    choice.lastResort = true;
    state.memory.gained = 0.0;
    for (int i = 0; i < substeps; ++i) {
      momentum_.before(model, parameters, inputs, state);
      lastResort_->step(model, parameters, inputs, state);
      momentum_.after(model, parameters.timeStep, parameters.timeStep, state);
    }
    state.time = time;
    slowDown(model, pieces_.get(model, freePieces), energyOf(model, parameters, state).total() - allowed, state);
  }

  void takeFiner(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                 const StepInputs& inputs, StepPlan plan, const ClothState& state, StepChoice& choice) {
    plan.substeps *= 2;
    run_.run(model, rates, parameters, inputs, plan, state, {});
    choice.passes += plan.cost();
    finer_ = state;
    run_.store(finer_);
  }

  /// The error of as many such steps as fit into the error's time, as if all went the same way; then how many passes
  /// would bring it to the tolerance. Errors of neighbours are averaged first: fast small vibrations, whose phase no
  /// step of this length gets right, and rounding do not carry anything away.
  void learn(const ClothModel& model, const StepParameters& parameters, const StepPlan& plan, ClothState& state) {
    constexpr int rings = 3;
    std::vector<Vec3>& difference = finer_.positions;
    for (std::size_t i = 0; i < difference.size(); ++i) {
      difference[i] -= state.positions[i];
    }
    for (int ring = 0; ring < rings; ++ring) {
      averageOverRings(model, difference);
    }
    double sum = 0.0;
    for (const Vec3& each : difference) {
      sum += each.norm();
    }
    const double order = plan.scheme == ExplicitScheme::Pefrl ? 4.0 : 2.0;
    const double whole = 1.0 / (1.0 - std::exp2(-order));
    const double error = whole * errorTime / parameters.timeStep * sum / static_cast<double>(state.positions.size());
    if (!std::isfinite(error)) {
      return;
    }
    const double passes = plan.cost() * std::pow(error / parameters.errorTolerance, 1.0 / order);
    state.memory.error = error;
    state.memory.passes = std::max({1.0, 0.5 * plan.cost(), passes});
  }

  /// Each value becomes the mean of itself and its neighbours'.
  void averageOverRings(const ClothModel& model, std::vector<Vec3>& values) {
    averaged_.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      Vec3 sum = values[i];
      for (int e = model.springEnds.begin[i]; e < model.springEnds.begin[i + 1]; ++e) {
        sum += values[static_cast<std::size_t>(model.springEnds.values[static_cast<std::size_t>(e)].neighbour)];
      }
      averaged_[i] = sum / (1.0 + model.springEnds.begin[i + 1] - model.springEnds.begin[i]);
    }
    values.swap(averaged_);
  }

  AdaptiveRun<T> run_;
  EnergyGuard guard_;
  std::unique_ptr<Solver> lastResort_;
  MomentumKeeper momentum_;
  ModelCache<std::vector<std::vector<std::size_t>>> pieces_;
  ClothState finer_;
  ClothState after_;
  std::vector<Vec3> averaged_;
};

class AutoSolver final : public Solver {
 public:
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) override {
    if (rest_.holds(model, parameters, inputs, state)) {
      state.time += parameters.timeStep;
      return {.choice = StepChoice{.substeps = 0, .passes = 0, .resting = true}};
    }
    const LocalRates& rates = rates_.get(model, localRatesOf);
    return isTakenInDouble(model, rates, parameters, state) ? double_.step(model, rates, parameters, inputs, state)
                                                            : single_.step(model, rates, parameters, inputs, state);
  }

 private:
  static bool isTakenInDouble(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                              const ClothState& state) {
    if (parameters.precision == Precision::Double || dampingRounds(rates, parameters)) {
      return true;
    }
    const double farthest = farthestOf(state.positions);
    return roundingHeats(model, rates, parameters, farthest) ||
           roundingShows(model, rates, parameters, state.memory, farthest);
  }

  RestWatch rest_;
  ModelCache<LocalRates> rates_;
  AdaptiveStep<float> single_;
  AdaptiveStep<double> double_;
};

/// What it costs that cloth is too stiff and fine for the work allowed, time or stiffness, and how much work would do.
std::string autoWarning(const ClothModel& model, const StepParameters& parameters) {
  constexpr double heldTo = 1.8;  // what h omega held springs are held to
  const double frequency = largestFrequency(model, parameters);
  const double passes = passesInBudget(model, parameters);
  const double hardness = std::max(frequency * parameters.timeStep, 1e-30);
  if (stretchedBudget * passes * 2.0 >= hardness) {
    return {};
  }
  const double needed = std::ceil(0.5 * frequency * static_cast<double>(model.springs.size()) * 1e-6);
  std::ostringstream words;
  words << std::setprecision(2);
  if (mayBeSoftened(model, parameters)) {
    const double held = parameters.soften ? passes : passesAtMost(model, parameters);
    const double carried = std::floor(held / costWithLevels) * heldTo / hardness;
    words << "The work allowed is too little for cloth so stiff and fine: stretching is carried by coarse groups, and "
          << "springs keep " << 100.0 * carried * carried
          << " % of their stiffness. All of it needs auto.cost = " << std::fixed << std::setprecision(0) << needed
          << (parameters.soften ? "." : " and auto.soften = off.");
  } else {
    words << "Cloth so stiff and fine takes up to " << 0.5 * hardness / passes
          << " times the work allowed: slow motion. Softer springs would keep pace (auto.soften = on).";
  }
  return words.str();
}

}  // namespace

SolverInfo solvers::adaptive() {
  return {.name = "auto",
          .title = "Auto",
          .help =
              "Chooses for itself: explicit steps of second or fourth order, as many substeps as the cloth and the "
              "tolerance need; an energy guard takes a step again that would explode. Where the work allowed does not "
              "suffice for cloth so stiff and fine, the clock falls behind, or, if that is wished, springs keep what a "
              "substep carries and coarse groups of vertices carry the tension. What is the case is said.",
          .source = "Drape (docs/theory/auto.md), on Stoermer-Verlet and Omelyan, Mryglod and Folk, 2002",
          .backwardEuler = false,
          .choosesSubsteps = true,
          .settings = {"precision", "auto.cost", "auto.soften", "auto.budget", "auto.tolerance"},
          .warning = autoWarning,
          .stepLimit = nullptr,
          .make = []() -> std::unique_ptr<Solver> { return std::make_unique<AutoSolver>(); }};
}

}  // namespace drape
