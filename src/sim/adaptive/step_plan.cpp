#include "sim/adaptive/step_plan.hpp"

#include "sim/measures.hpp"
#include "sim/simd/damping_stages.hpp"
#include "sim/stability.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace drape {
namespace {

/// Of Verlet's estimated limit, which a sheet's true one exceeds by 9 % and more: where nothing rattles, and the most
/// that a short budget is stretched to.
constexpr double comfortable = 0.9;
constexpr double atMost = 1.02;
/// h omega that held springs are held to. Crumpled cloth is up to 1.22 times as fast as its rest shape.
constexpr double heldTo = 1.8;
/// A substep of the fourth order takes four passes and is stable to about h omega = 2.5.
constexpr double passesOfFourthOrder = 2.0;
/// Held springs that keep at least so much do without coarse levels.
constexpr double enoughStiffness = 0.5;
/// So do those that the load stretches by less than so much next to the pins (docs/theory/auto.md).
constexpr double smallStrain = 0.001;
/// The same where damping is taken by itself: its stages bear h omega = 1.62 at the worst of all rates.
constexpr double heldBeside = 1.5;
/// Stages of damping in a substep, at most: rounding grows with their square. In float, and in double.
constexpr double mostStagesInFloat = 100.0;
constexpr double mostStages = 10000.0;
constexpr double fewestPasses = 4.0;
/// Passes of a first step, about which nothing is known yet: on the safe side.
constexpr double firstPasses = 64.0;
constexpr double firstOfLimit = 2.0;
/// No tolerance asks for more passes than so many times what is stable: a chaotic motion would ask without end.
constexpr double mostOfLimit = 8.0;

bool dependsOnPositionsAlone(const StepParameters& parameters, const StepInputs& inputs) {
  return parameters.damping == 0.0 && parameters.drag == 0.0 && parameters.lift == 0.0 && !inputs.attachment;
}

/// The value that no more than one in so many exceed; 0 of none.
double smallestBut(std::vector<double>& values, std::size_t oneIn) {
  if (values.empty()) {
    return 0.0;
  }
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() - 1 - (values.size() - 1) / oneIn);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// How strong damping is over a whole step, h lambda with the largest rate but for the fastest hundredth [-].
double dampedOver(const LocalRates& rates, const StepParameters& parameters) {
  return parameters.timeStep * rates.mostDamping * parameters.damping;
}

/// The same for the fastest vertex.
double fastestDampedOver(const ClothModel& model, const StepParameters& parameters) {
  return parameters.timeStep * model.unitDampingRate * parameters.damping;
}

/// Stages of damping by itself in each of so many substeps.
int stagesIn(double damped, double substeps) {
  return dampingStages(damped / substeps);
}

/// What substeps cost that take damping by itself, in passes.
double costBeside(double damped, double substeps) {
  return substeps * (1.0 + costOfDampingStage * stagesIn(damped, substeps));
}

/// How many substeps with damping by itself so many passes pay for: n of them take about n + c sqrt(n damped). As many
/// at least as keep the stages to what float bears.
int substepsBeside(double damped, double passes) {
  const double root = 0.5 * costOfDampingStage * std::sqrt(damped);
  const double paid = std::sqrt(root * root + std::max(0.0, passes)) - root;
  const double fewest = damped / (mostStages * mostStages);
  return static_cast<int>(std::max({1.0, std::ceil(fewest), std::floor(paid * paid)}));
}

/// Springs that are held to what so many substeps carry. Damping is part of the kick where all vertices bear that.
StepPlan heldAt(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters, int substeps) {
  const double inKick = 2.0 * fastestDampedOver(model, parameters) / substeps;
  if (inKick > 1.0) {
    const int stages = stagesIn(dampedOver(rates, parameters), substeps);
    return {.substeps = substeps, .carried = heldBeside, .dampingStages = stages};
  }
  return {.substeps = substeps, .carried = std::sqrt(heldTo * heldTo - inKick)};
}

/// The same for what costs so many passes.
StepPlan heldPlan(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters, double passes) {
  const bool inKick = 2.0 * fastestDampedOver(model, parameters) <= std::floor(passes);
  return heldAt(model, rates, parameters,
                inKick ? static_cast<int>(passes) : substepsBeside(dampedOver(rates, parameters), passes));
}

/// The least that a step takes where springs and damping stay as they are.
struct Need {
  bool beside = false;  ///< damping by itself is cheaper than substeps for it
  double calm = 0.0;    ///< substeps at a distance from the limit
  double fewest = 0.0;  ///< substeps
  double passes = 0.0;  ///< that the calm ones cost
};

/// @param damped h lambda over the step, of damping by itself
Need needOf(const ClothModel& model, const StepParameters& parameters, double damped) {
  const double limit = parameters.timeStep / verletStepLimit(model, parameters);
  const double hardness = parameters.timeStep * largestFrequency(model, parameters);
  const double beside =
      std::max({1.0, std::ceil(hardness / heldBeside), std::ceil(damped / (mostStages * mostStages))});
  const double cost = costBeside(damped, beside);
  if (cost < limit / comfortable) {
    return {true, beside, beside, cost};
  }
  return {false, std::ceil(limit / comfortable), std::ceil(limit / atMost), limit / comfortable};
}

/// The share of its stiffness that a vertex of that rate [1/kg] keeps under a plan.
double shareAt(double rate, const StepParameters& parameters, const StepPlan& plan) {
  const double h = parameters.timeStep / plan.substeps;
  const double speed = h * h * parameters.stiffness * rate;
  return plan.carried > 0.0 && speed > 0.0 ? std::min(1.0, plan.carried * plan.carried / speed) : 1.0;
}

/// Springs that are held only where the fastest hundredth of the vertices are, however many substeps that takes.
StepPlan barelyHeldPlan(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                        int substeps) {
  const double hardness = parameters.timeStep * std::sqrt(parameters.stiffness * rates.most);
  StepPlan plan = heldAt(model, rates, parameters, std::max(substeps, static_cast<int>(std::ceil(hardness / heldTo))));
  if (shareAt(rates.most, parameters, plan) < 1.0) {
    const double damped = std::sqrt(heldTo * heldTo - 1.0);
    plan = heldAt(model, rates, parameters, std::max(substeps, static_cast<int>(std::ceil(hardness / damped))));
  }
  return plan;
}

/// How far weight and wind would stretch the springs next to the pins [-], as they are held under a plan. Infinite
/// where nothing is pinned: what carries the cloth then is not known.
double strainAtPins(const LocalRates& rates, const StepParameters& parameters, const StepPlan& plan) {
  constexpr double alongWind = 0.1;  // of the pressure from ahead, on cloth that gives way to it
  const double wind = alongWind * mostForceOfWind(rates, parameters);
  const double kept = shareAt(rates.median, parameters, plan) * parameters.stiffness;
  return (parameters.gravity * rates.mass + wind) / (kept * rates.pinnedLength);
}

/// The passes that the tolerance asks for, whatever work is allowed.
double passesWanted(const Need& need, const StepMemory& memory) {
  const double wanted = memory.passes > 0.0 ? memory.passes : firstPasses + firstOfLimit * comfortable * need.passes;
  const double stable = std::max(fewestPasses, need.passes);
  return std::clamp(wanted, stable, mostOfLimit * std::max(stable, firstPasses / 8.0));
}

}  // namespace

// In eight maxima, since in one each comparison would wait for the one before.
double farthestOf(const std::vector<Vec3>& positions) {
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> most{};
  const double* const values = positions.empty() ? nullptr : positions.front().data();
  const std::size_t count = 3 * positions.size();
  for (std::size_t i = 0; i + lanes <= count; i += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      most[lane] = std::max(most[lane], std::abs(values[i + lane]));
    }
  }
  for (std::size_t i = count - count % lanes; i < count; ++i) {
    most[0] = std::max(most[0], std::abs(values[i]));
  }
  return *std::max_element(most.begin(), most.end());
}

LocalRates localRatesOf(const ClothModel& model) {
  LocalRates rates;
  std::vector<double> free;
  std::vector<double> freeDamping;
  for (std::size_t i = 0; i < model.restPositions.size(); ++i) {
    const double ends = model.springEnds.begin[i + 1] - model.springEnds.begin[i];
    rates.unit.push_back(model.pinned[i] ? 0.0 : unitFrequencySquared(model, i));
    rates.damping.push_back(model.pinned[i] ? 0.0 : 2.0 * ends / model.vertexMass[i]);
    if (!model.pinned[i]) {
      free.push_back(rates.unit.back());
      freeDamping.push_back(rates.damping.back());
    }
  }
  rates.median = smallestBut(free, 2);
  rates.most = smallestBut(free, 100);
  rates.mostDamping = smallestBut(freeDamping, 100);
  rates.diagonal = diagonalOf(model);
  rates.mass = model.totalMass();
  rates.area = model.restArea();
  for (const Spring& spring : model.springs) {
    const bool carries =
        model.pinned[static_cast<std::size_t>(spring.a)] != model.pinned[static_cast<std::size_t>(spring.b)];
    rates.pinnedLength += carries ? spring.relativeStiffness * spring.restLength : 0.0;
  }
  return rates;
}

double mostForceOfWind(const LocalRates& rates, const StepParameters& parameters) {
  const double speed = parameters.wind.norm();
  return 0.5 * parameters.airDensity * (parameters.drag + parameters.lift) * speed * speed * rates.area;
}

double passesInBudget(const ClothModel& model, const StepParameters& parameters) {
  const auto springs = static_cast<double>(std::max<std::size_t>(1, model.springs.size()));
  return std::max(fewestPasses, parameters.work * 1e6 * parameters.timeStep / springs);
}

double passesAtMost(const ClothModel& model, const StepParameters& parameters) {
  constexpr double evaluations = 2e9;  // of a spring: several seconds
  const double springs = static_cast<double>(std::max<std::size_t>(1, model.springs.size()));
  return std::max(passesInBudget(model, parameters), evaluations / springs);
}

bool mayBeSoftened(const ClothModel& model, const StepParameters& parameters) {
  return parameters.soften ||
         needOf(model, parameters, fastestDampedOver(model, parameters)).passes > passesAtMost(model, parameters);
}

StepPlan saferThan(StepPlan plan) {
  constexpr double less = 0.8;
  constexpr double asPlanned = 1.7;
  const bool finer = !plan.softens || plan.carried < asPlanned;
  plan.carried *= plan.softens && finer ? 0.5 : less;
  if (finer) {
    plan.substeps = 2 * plan.passes();
  }
  plan.scheme = ExplicitScheme::Verlet;
  return plan;
}

StepPlan planStep(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                  const StepInputs& inputs, const StepMemory& memory) {
  constexpr double mostPasses = 1e6;
  const double budget = std::min(mostPasses, passesInBudget(model, parameters));
  const double damped = dampedOver(rates, parameters);
  const Need need = needOf(model, parameters, damped);
  const double passes = std::min(budget, passesWanted(need, memory));
  const double hardness = parameters.timeStep * largestFrequency(model, parameters);
  if (passes >= passesOfFourthOrder * hardness && dependsOnPositionsAlone(parameters, inputs)) {
    return {.scheme = ExplicitScheme::Pefrl, .substeps = static_cast<int>(passes / 4.0)};
  }
  const auto asTheyAre = [&](int substeps) {
    return StepPlan{.substeps = substeps, .dampingStages = need.beside ? stagesIn(damped, substeps) : 0};
  };
  const double bearable = std::max(stretchedBudget * passes, costWithLevels * fewestPasses);
  const int paid = need.beside ? substepsBeside(damped, passes) : static_cast<int>(passes);
  const double fewestCost = need.beside ? need.passes : need.fewest;
  const int substeps = static_cast<int>(need.fewest > paid && fewestCost <= bearable ? need.fewest : paid);
  if (substeps >= need.fewest) {
    return asTheyAre(substeps);
  }
  if (!mayBeSoftened(model, parameters)) {
    // Slow in any case: at a distance from the limit, where energy comes and goes less and fewer steps are taken again.
    const StepPlan barely = barelyHeldPlan(model, rates, parameters, substeps);
    return barely.substeps < need.calm ? barely : asTheyAre(static_cast<int>(need.calm));
  }
  const double held = parameters.soften ? passes : passesAtMost(model, parameters);
  StepPlan softer = heldPlan(model, rates, parameters, held);
  softer.softens = true;
  const bool carries = !inputs.attachment && strainAtPins(rates, parameters, softer) < smallStrain;
  if (carries || medianShare(rates, parameters, softer) >= enoughStiffness) {
    return softer;
  }
  StepPlan withLevels = heldPlan(model, rates, parameters, std::max(fewestPasses, held / costWithLevels));
  withLevels.levels = true;
  withLevels.softens = true;
  return withLevels;
}

bool dampingRounds(const LocalRates& rates, const StepParameters& parameters) {
  return dampedOver(rates, parameters) > mostStagesInFloat * mostStagesInFloat;
}

bool roundingHeats(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                   double farthest) {
  constexpr double measured = 0.02;
  constexpr double inMotion = 0.002;  // of what falling sets free, in a second [1/s]
  constexpr double leastFall = 1.0;   // [m^2/s^2]
  constexpr double atRest = 1e-7;     // [W/kg]
  const double hardness = parameters.timeStep * std::sqrt(parameters.stiffness);
  const double passes = parameters.soften
                            ? passesInBudget(model, parameters)
                            : std::clamp(hardness * std::sqrt(rates.most) / heldTo, passesInBudget(model, parameters),
                                         passesAtMost(model, parameters));
  const double substeps = std::min(passes, hardness * model.unitFrequency / heldTo);
  const double h = parameters.timeStep / std::max(1.0, substeps);
  const double omegaSquared = std::min(parameters.stiffness * rates.median, heldTo * heldTo / (h * h));
  const double rounding = 0x1p-24 * farthest;
  const double heating = 0.5 * measured * omegaSquared * rounding * rounding / h;  // [W/kg]
  const bool comesToRest = (parameters.damping > 0.0 || parameters.drag > 0.0) && parameters.wind.isZero(0.0);
  return heating > (comesToRest ? atRest : inMotion * std::max(leastFall, parameters.gravity * rates.diagonal));
}

bool roundingShows(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                   const StepMemory& memory, double farthest) {
  constexpr double measured = 0.25;
  constexpr double costOfDouble = 2.0;
  const double passes = passesWanted(needOf(model, parameters, dampedOver(rates, parameters)), memory);
  if (costOfDouble * passes > passesInBudget(model, parameters)) {
    return false;
  }
  const double count = passes * std::max(1.0, errorTime / parameters.timeStep);
  return measured * 0x1p-24 * farthest * std::sqrt(count) > parameters.errorTolerance;
}

double medianShare(const LocalRates& rates, const StepParameters& parameters, const StepPlan& plan) {
  return shareAt(rates.median, parameters, plan);
}

}  // namespace drape
