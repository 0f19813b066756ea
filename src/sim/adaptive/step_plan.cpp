#include "sim/adaptive/step_plan.hpp"

#include "sim/measures.hpp"
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
/// The most of damping's own limit that held springs take, as 2 h c with its rate c.
constexpr double dampingHeldTo = 1.0;
constexpr double fewestPasses = 4.0;
/// Passes of a first step, about which nothing is known yet: on the safe side.
constexpr double firstPasses = 64.0;
constexpr double firstOfLimit = 2.0;
/// No tolerance asks for more passes than so many times what is stable: a chaotic motion would ask without end.
constexpr double mostOfLimit = 8.0;

bool dependsOnPositionsAlone(const StepParameters& parameters, const StepInputs& inputs) {
  return parameters.damping == 0.0 && parameters.drag == 0.0 && parameters.lift == 0.0 && !inputs.grab;
}

/// The largest coordinate [m]. In eight maxima, since in one each comparison would wait for the one before.
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

/// The value that no more than one in so many exceed; 0 of none.
double smallestBut(std::vector<double>& values, std::size_t oneIn) {
  if (values.empty()) {
    return 0.0;
  }
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() - 1 - (values.size() - 1) / oneIn);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Springs that are held to what so many substeps carry.
StepPlan heldPlan(const ClothModel& model, const StepParameters& parameters, int substeps) {
  StepPlan plan{.substeps = substeps, .damping = parameters.damping};
  const double h = parameters.timeStep / substeps;
  const double damped = 2.0 * h * model.unitDampingRate * parameters.damping;
  if (damped > dampingHeldTo) {
    plan.damping *= dampingHeldTo / damped;
  }
  plan.carried = std::sqrt(heldTo * heldTo - std::min(damped, dampingHeldTo));
  return plan;
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
  StepPlan plan = heldPlan(model, parameters, std::max(substeps, static_cast<int>(std::ceil(hardness / heldTo))));
  if (shareAt(rates.most, parameters, plan) < 1.0) {
    const double damped = std::sqrt(heldTo * heldTo - dampingHeldTo);
    plan = heldPlan(model, parameters, std::max(substeps, static_cast<int>(std::ceil(hardness / damped))));
  }
  return plan;
}

}  // namespace

LocalRates localRatesOf(const ClothModel& model) {
  LocalRates rates;
  std::vector<double> free;
  for (std::size_t i = 0; i < model.restPositions.size(); ++i) {
    rates.unit.push_back(model.pinned[i] ? 0.0 : unitFrequencySquared(model, i));
    if (!model.pinned[i]) {
      free.push_back(rates.unit.back());
    }
  }
  rates.median = smallestBut(free, 2);
  rates.most = smallestBut(free, 100);
  rates.diagonal = diagonalOf(model);
  rates.mass = model.totalMass();
  return rates;
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
         parameters.timeStep / verletStepLimit(model, parameters) > passesAtMost(model, parameters);
}

StepPlan saferThan(StepPlan plan) {
  constexpr double less = 0.8;
  constexpr double asPlanned = 1.7;
  if (plan.carried < asPlanned || !plan.softens) {
    plan.substeps = 2 * plan.passes();
  }
  plan.scheme = ExplicitScheme::Verlet;
  plan.carried *= less;
  return plan;
}

StepPlan planStep(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                  const StepInputs& inputs, const StepMemory& memory) {
  constexpr double mostPasses = 1e6;
  const double budget = std::min(mostPasses, passesInBudget(model, parameters));
  const double needed = parameters.timeStep / verletStepLimit(model, parameters);
  const double wanted = memory.passes > 0.0 ? memory.passes : firstPasses + firstOfLimit * needed;
  const double stable = std::max(fewestPasses, needed / comfortable);
  const double passes = std::min(budget, std::clamp(wanted, stable, mostOfLimit * std::max(stable, firstPasses / 8.0)));
  const double hardness = parameters.timeStep * largestFrequency(model, parameters);
  if (passes >= passesOfFourthOrder * hardness && dependsOnPositionsAlone(parameters, inputs)) {
    return {.scheme = ExplicitScheme::Pefrl, .substeps = static_cast<int>(passes / 4.0)};
  }
  const double fewest = std::ceil(needed / atMost);
  const double bearable = std::max(stretchedBudget * passes, costWithLevels * fewestPasses);
  const int substeps = static_cast<int>(fewest > passes && fewest <= bearable ? fewest : passes);
  if (substeps >= fewest) {
    return {.substeps = substeps, .damping = parameters.damping};
  }
  if (!mayBeSoftened(model, parameters)) {
    const StepPlan barely = barelyHeldPlan(model, rates, parameters, substeps);
    // Slow in any case: at a distance from the limit, where energy comes and goes less and fewer steps are taken again.
    const double calm = std::ceil(needed / comfortable);
    return barely.substeps < calm ? barely
                                  : StepPlan{.substeps = static_cast<int>(calm), .damping = parameters.damping};
  }
  const double held = parameters.soften ? passes : passesAtMost(model, parameters);
  StepPlan softer = heldPlan(model, parameters, static_cast<int>(held));
  softer.softens = true;
  if (medianShare(rates, parameters, softer) >= enoughStiffness) {
    return softer;
  }
  StepPlan withLevels = heldPlan(model, parameters, static_cast<int>(std::max(fewestPasses, held / costWithLevels)));
  withLevels.levels = true;
  withLevels.softens = true;
  return withLevels;
}

bool roundingHeats(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                   const ClothState& state) {
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
  const double rounding = 0x1p-24 * farthestOf(state.positions);
  const double heating = 0.5 * measured * omegaSquared * rounding * rounding / h;  // [W/kg]
  const bool comesToRest = (parameters.damping > 0.0 || parameters.drag > 0.0) && parameters.wind.isZero(0.0);
  return heating > (comesToRest ? atRest : inMotion * std::max(leastFall, parameters.gravity * rates.diagonal));
}

double medianShare(const LocalRates& rates, const StepParameters& parameters, const StepPlan& plan) {
  return shareAt(rates.median, parameters, plan);
}

}  // namespace drape
