#include "sim/adaptive/step_plan.hpp"

#include "sim/adaptive/tuning.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/forces/stability.hpp"
#include "sim/simd/damping_stages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drape::sim::adaptive {
namespace {

bool dependsOnPositionsAlone(const CommonParameters& parameters, const StepInputs& inputs) {
  return parameters.material.damping == 0.0 && !parameters.air.acts() && !inputs.attachment &&
         inputs.contacts == nullptr;
}

/// True if a step with that many force evaluations is of fourth order.
bool takesFourthOrder(double evaluations, const ClothModel& model, const CommonParameters& parameters,
                      const StepInputs& inputs) {
  const double hOmega = parameters.timeStep * largestFrequency(model, parameters);
  return evaluations >= tuning.fourthOrderEvaluations * hOmega && dependsOnPositionsAlone(parameters, inputs);
}

/// H lambda of damping over the time step H, with the 99th percentile of the rates [-].
double dampingNumber(const LocalRates& rates, const CommonParameters& parameters) {
  return parameters.timeStep * rates.dampingPercentile99 * parameters.material.damping;
}

/// The same with the largest rate.
double maxDampingNumber(const ClothModel& model, const CommonParameters& parameters) {
  return parameters.timeStep * model.unitDampingRate * parameters.material.damping;
}

/// Damping stages in each substep.
int dampingStagesFor(double damped, double substeps) {
  return simd::dampingStages(damped / substeps);
}

/// Cost of substeps that integrate damping in stages, in force evaluations.
double costWithSplitDamping(double damped, double substeps) {
  return substeps * (1.0 + costOfDampingStage * dampingStagesFor(damped, substeps));
}

/// The number of substeps with damping stages for a cost in force evaluations: n substeps cost about
/// n + c sqrt(n damped). At least as many as keep the stages of a substep below their limit.
int substepsWithSplitDamping(double damped, double evaluations) {
  const double root = 0.5 * costOfDampingStage * std::sqrt(damped);
  const double affordable = std::sqrt(root * root + std::max(0.0, evaluations)) - root;
  const double minimum = damped / (tuning.maxDampingStages * tuning.maxDampingStages);
  return static_cast<int>(std::max({1.0, std::ceil(minimum), std::floor(affordable * affordable)}));
}

/// A plan with this number of substeps, with springs clamped to what is stable. Damping is part of the kick where that
/// is stable for all vertices.
StepPlan clampedPlan(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
                     int substeps) {
  const double inKick = 2.0 * maxDampingNumber(model, parameters) / substeps;
  if (inKick > 1.0) {
    const int stages = dampingStagesFor(dampingNumber(rates, parameters), substeps);
    return {.substeps = substeps, .hOmegaLimit = tuning.clampHOmegaWithDampingStages, .dampingStages = stages};
  }
  return {.substeps = substeps, .hOmegaLimit = std::sqrt(tuning.clampHOmega * tuning.clampHOmega - inKick)};
}

/// The same for a cost in force evaluations.
StepPlan clampedPlanOfCost(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
                           double cost) {
  const bool inKick = 2.0 * maxDampingNumber(model, parameters) <= std::floor(cost);
  return clampedPlan(
      model, rates, parameters,
      inKick ? static_cast<int>(cost) : substepsWithSplitDamping(dampingNumber(rates, parameters), cost));
}

/// The substeps that a stable step needs without clamping.
struct StableSteps {
  bool splitDamping = false;  ///< damping stages are cheaper than more substeps
  double preferred = 0.0;     ///< substeps at a distance from the stability limit
  double minimum = 0.0;       ///< substeps at the stability limit
  double evaluations = 0.0;   ///< cost of the preferred substeps [force evaluations]
};

/// @param damped H lambda for damping in stages [-]
StableSteps stableStepsOf(const ClothModel& model, const CommonParameters& parameters, double damped) {
  const double limit = parameters.timeStep / verletStepLimit(model, parameters);
  const double hOmega = parameters.timeStep * largestFrequency(model, parameters);
  const double split = std::max({1.0, std::ceil(hOmega / tuning.clampHOmegaWithDampingStages),
                                 std::ceil(damped / (tuning.maxDampingStages * tuning.maxDampingStages))});
  const double cost = costWithSplitDamping(damped, split);
  const double preferred = stableEvaluations(model, parameters);
  if (cost < preferred) {
    return {true, split, split, cost};
  }
  // A fabric keeps the distance from the limit, even at a higher cost (AutoTuning::fabricFraction).
  const double minimum = model.fabric ? preferred : limit / tuning.limitFraction;
  return {false, std::ceil(preferred), std::ceil(minimum), preferred};
}

/// The stiffness scale under a plan at a vertex with that omega^2 / k [1/kg].
double stiffnessScaleAt(double rate, const CommonParameters& parameters, const StepPlan& plan) {
  const double h = parameters.timeStep / plan.substeps;
  const double hOmegaSquared = h * h * parameters.material.stiffness * rate;
  return plan.hOmegaLimit > 0.0 && hOmegaSquared > 0.0
             ? std::min(1.0, plan.hOmegaLimit * plan.hOmegaLimit / hOmegaSquared)
             : 1.0;
}

/// Enough substeps that only springs at the fastest hundredth of the vertices are clamped.
StepPlan minimallyClampedPlan(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
                              int substeps) {
  const double hOmega = parameters.timeStep * std::sqrt(parameters.material.stiffness * rates.percentile99);
  StepPlan plan = clampedPlan(model, rates, parameters,
                              std::max(substeps, static_cast<int>(std::ceil(hOmega / tuning.clampHOmega))));
  if (stiffnessScaleAt(rates.percentile99, parameters, plan) < 1.0) {
    const double limitWithDamping = std::sqrt(tuning.clampHOmega * tuning.clampHOmega - 1.0);
    plan = clampedPlan(model, rates, parameters,
                       std::max(substeps, static_cast<int>(std::ceil(hOmega / limitWithDamping))));
  }
  return plan;
}

/// The strain of the springs at the pins under weight and wind, with the stiffness that a plan leaves [-]. Infinite
/// without pins: the support of the cloth is then unknown.
double strainAtPins(const LocalRates& rates, const CommonParameters& parameters, const StepPlan& plan) {
  const double stiffness = stiffnessScaleAt(rates.median, parameters, plan) * parameters.material.stiffness;
  return loadOf(rates, parameters) / (stiffness * rates.pinnedLength);
}

/// The cost of a force evaluation, in evaluations of one spring.
double costOfEvaluation(const ClothModel& model) {
  const auto edges = static_cast<double>(std::max<std::size_t>(1, model.springs.size()));
  if (!model.fabric) {
    return edges;
  }
  return edges * (model.fabric->bends() ? tuning.fabricCost : tuning.membraneCost);
}

/// The force evaluations that the error tolerance asks for, without regard to the cost budget.
double evaluationsForTolerance(const StableSteps& need, const AutoOptions& options, const StepMemory& memory) {
  const double wanted =
      memory.forceEvaluations > 0.0
          ? memory.forceEvaluations
          : tuning.firstEvaluations + tuning.firstLimitFactor * tuning.preferredFraction * need.evaluations;
  const double stable = std::max(tuning.minEvaluations, need.evaluations);
  const double tighter =
      std::clamp(std::sqrt(tuning.tightTolerance / options.errorTolerance), 1.0, tuning.maxTightening);
  return std::clamp(wanted, stable, tighter * tuning.maxLimitFactor * std::max(stable, tuning.minLimitEvaluations));
}

/// Lets bending and air act in one of several substeps where that is accurate, and adds substeps so that their number
/// is a multiple of these intervals. Chooses the intervals with the least cost.
StepPlan withSlowForces(StepPlan plan, const ClothModel& model, const LocalRates& rates,
                        const CommonParameters& parameters) {
  if (!model.fabric || plan.scheme != ExplicitScheme::Verlet) {
    return plan;
  }
  const double substep = parameters.timeStep / plan.substeps;
  const auto longest = [&](double time) {
    return std::clamp(static_cast<int>(std::min(time, parameters.timeStep) / substep), 1, tuning.maxSlowInterval);
  };
  const bool airActs = parameters.air.acts();
  const bool bends = rates.bendingFrequency > 0.0;
  const int longestAir = airActs ? longest(tuning.maxAirTime) : tuning.maxSlowInterval;
  const int longestBending = bends ? longest(tuning.maxBendingHOmega / rates.bendingFrequency) : longestAir;
  const double airCost = airActs ? tuning.airCost : 0.0;
  const double bendingCost = bends ? tuning.bendingCost : 0.0;
  StepPlan best = plan;
  double lowestCost = std::numeric_limits<double>::max();
  for (int air = 1; air <= std::min(longestAir, longestBending); air += 2) {
    for (int bending = air; bending <= longestBending; bending += 2 * air) {
      const int substeps = (plan.substeps + bending - 1) / bending * bending;
      const double cost = substeps * (1.0 + bendingCost / bending + airCost / air);
      if (cost < lowestCost) {
        lowestCost = cost;
        best.substeps = substeps;
        best.airInterval = air;
        best.bendingInterval = bending;
      }
    }
  }
  return best;
}

StepPlan planWithoutSlowForces(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
                               const AutoOptions& options, const StepInputs& inputs, const StepMemory& memory) {
  const double budget = std::min(tuning.maxBudgetedEvaluations, evaluationsInBudget(model, parameters, options));
  const double damped = dampingNumber(rates, parameters);
  const StableSteps need = stableStepsOf(model, parameters, damped);
  const double evaluations = std::min(budget, evaluationsForTolerance(need, options, memory));
  if (takesFourthOrder(evaluations, model, parameters, inputs)) {
    return {.scheme = ExplicitScheme::Pefrl, .substeps = static_cast<int>(evaluations / 4.0)};
  }
  const auto unclamped = [&](int substeps) {
    return StepPlan{.substeps = substeps, .dampingStages = need.splitDamping ? dampingStagesFor(damped, substeps) : 0};
  };
  const double maxCost = std::max(toleratedCostRatio * evaluations, costWithLevels * tuning.minEvaluations);
  const int affordable =
      need.splitDamping ? substepsWithSplitDamping(damped, evaluations) : static_cast<int>(evaluations);
  const double minCost = need.splitDamping ? need.evaluations : need.minimum;
  const int substeps = static_cast<int>(need.minimum > affordable && minCost <= maxCost ? need.minimum : affordable);
  if (substeps >= need.minimum) {
    return unclamped(substeps);
  }
  if (!maySoften(model, parameters, options)) {
    if (model.fabric) {
      return unclamped(static_cast<int>(need.preferred));
    }
    // The step exceeds the budget anyway. So the plan keeps a distance from the stability limit: the energy oscillates
    // less, and fewer steps are retried.
    const StepPlan clamped = minimallyClampedPlan(model, rates, parameters, substeps);
    return clamped.substeps < need.preferred ? clamped : unclamped(static_cast<int>(need.preferred));
  }
  const double cost = options.soften ? evaluations : maxEvaluations(model, parameters, options);
  if (memory.taut && inputs.contacts == nullptr && !inputs.attachment) {
    return {.substeps = std::max(1, static_cast<int>((cost + tuning.levelOverhead) / costOfImplicitSubstep)),
            .isImplicit = true};
  }
  StepPlan softer = clampedPlanOfCost(model, rates, parameters, cost);
  softer.softens = true;
  const bool hardlyLoaded = !inputs.attachment && strainAtPins(rates, parameters, softer) < tuning.smallStrain;
  if (hardlyLoaded || medianStiffnessScale(rates, parameters, softer) >= tuning.enoughStiffness) {
    return softer;
  }
  if (memory.withoutLevels > 1) {
    softer = clampedPlanOfCost(model, rates, parameters, cost + tuning.levelOverhead);
    softer.softens = true;
    return softer;
  }
  StepPlan withLevels =
      clampedPlanOfCost(model, rates, parameters, std::max(tuning.minEvaluations, cost / costWithLevels));
  withLevels.usesCoarseLevels = true;
  withLevels.softens = true;
  return isHardlySlowerThanLevels(minCost, withLevels.substeps) ? unclamped(static_cast<int>(need.minimum))
                                                                : withLevels;
}

}  // namespace

// Independent maxima, since each comparison with a single one waits for the one before.
double maxCoordinate(const std::vector<Vec3>& positions, const Vec3& origin) {
  constexpr std::size_t lanes = 24;  // whole vectors
  std::array<double, lanes> maxima{};
  std::array<double, lanes> origins{};
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    origins[lane] = origin[static_cast<Eigen::Index>(lane % 3)];
  }
  const double* const values = positions.empty() ? nullptr : positions.front().data();
  const std::size_t count = 3 * positions.size();
  for (std::size_t i = 0; i + lanes <= count; i += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      maxima[lane] = std::max(maxima[lane], std::abs(values[i + lane] - origins[lane]));
    }
  }
  for (std::size_t i = count - count % lanes; i < count; ++i) {
    maxima[0] = std::max(maxima[0], std::abs(values[i] - origins[i % 3]));
  }
  return *std::max_element(maxima.begin(), maxima.end());
}

double maxWindForce(const LocalRates& rates, const CommonParameters& parameters) {
  const double speed = parameters.air.wind.norm();
  return 0.5 * parameters.air.density * (parameters.air.drag + parameters.air.lift) * speed * speed * rates.area;
}

double loadOf(const LocalRates& rates, const CommonParameters& parameters) {
  const double wind = tuning.windLoadFraction * maxWindForce(rates, parameters);
  return parameters.gravity * rates.mass + wind;
}

double stableEvaluations(const ClothModel& model, const CommonParameters& parameters) {
  const double fraction = model.fabric ? tuning.fabricFraction : tuning.preferredFraction;
  return parameters.timeStep / verletStepLimit(model, parameters) / fraction;
}

double evaluationsInBudget(const ClothModel& model, const CommonParameters& parameters, const AutoOptions& options) {
  const double springs = costOfEvaluation(model);
  return std::max(tuning.minEvaluations, options.costBudget * 1e6 * parameters.timeStep / springs);
}

double maxEvaluations(const ClothModel& model, const CommonParameters& parameters, const AutoOptions& options) {
  const double springs = costOfEvaluation(model);
  return std::max(evaluationsInBudget(model, parameters, options), tuning.maxSpringEvaluations / springs);
}

bool isHardlySlowerThanLevels(double evaluations, double substeps) {
  return evaluations <= toleratedCostRatio * (tuning.levelOverhead + costWithLevels * substeps);
}

bool maySoften(const ClothModel& model, const CommonParameters& parameters, const AutoOptions& options) {
  if (model.fabric) {
    return false;  // the moduli of a fabric are those of a real material
  }
  return options.soften || stableStepsOf(model, parameters, maxDampingNumber(model, parameters)).evaluations >
                               maxEvaluations(model, parameters, options);
}

StepPlan saferPlan(StepPlan plan) {
  plan.airInterval = plan.bendingInterval = 1;
  const bool finer = !plan.softens || plan.hOmegaLimit < tuning.minRetryHOmega;
  plan.hOmegaLimit *= plan.softens && finer ? 0.5 : tuning.retryClampFactor;
  if (finer) {
    plan.substeps = 2 * plan.forceEvaluations();
  }
  plan.scheme = ExplicitScheme::Verlet;
  return plan;
}

StepPlan planStep(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
                  const AutoOptions& options, const StepInputs& inputs, const StepMemory& memory) {
  const StepPlan plan = planWithoutSlowForces(model, rates, parameters, options, inputs, memory);
  return memory.everySubstep > 0 ? plan : withSlowForces(plan, model, rates, parameters);
}

bool dampingNeedsDouble(const LocalRates& rates, const CommonParameters& parameters) {
  return dampingNumber(rates, parameters) > tuning.maxDampingStagesInFloat * tuning.maxDampingStagesInFloat;
}

bool roundingAddsEnergy(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
                        const AutoOptions& options, const StepMemory& memory, double maxCoordinate, bool contactsAct) {
  const double rootStiffness =
      parameters.timeStep * std::sqrt(parameters.material.stiffness);  // times sqrt(omega^2/k): h omega
  const double evaluations =
      options.soften
          ? evaluationsInBudget(model, parameters, options)
          : std::clamp(rootStiffness * std::sqrt(rates.percentile99) / tuning.clampHOmega,
                       evaluationsInBudget(model, parameters, options), maxEvaluations(model, parameters, options));
  const double substeps = std::min(evaluations, rootStiffness * model.unitFrequency / tuning.clampHOmega);
  const double h = parameters.timeStep / std::max(1.0, substeps);
  const double omegaSquared =
      std::min(parameters.material.stiffness * rates.heatingRate, tuning.clampHOmega * tuning.clampHOmega / (h * h));
  const double rounding = 0x1p-24 * maxCoordinate;
  const double heating = 0.5 * tuning.roundingHeat * omegaSquared * rounding * rounding / h;  // [W/kg]
  const bool isSlow = memory.speed < tuning.slowSpeed || (contactsAct && !model.fabric);
  const bool comesToRest =
      isSlow && (parameters.material.damping > 0.0 || parameters.air.drag > 0.0) && parameters.air.wind.isZero(0.0);
  const double maxAtRest = contactsAct ? tuning.maxHeatingInContact : tuning.maxHeatingAtRest;
  return heating > (comesToRest ? maxAtRest
                                : tuning.maxHeatingInMotion *
                                      std::max(tuning.minFallEnergy, parameters.gravity * rates.diagonal));
}

bool roundingExceedsTolerance(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
                              const AutoOptions& options, const StepInputs& inputs, const StepMemory& memory,
                              double maxCoordinate) {
  const StableSteps need = stableStepsOf(model, parameters, dampingNumber(rates, parameters));
  const double evaluations = evaluationsForTolerance(need, options, memory);
  const double budget = evaluationsInBudget(model, parameters, options);
  const auto rounding = [&](double evaluationsOfStep) {
    const double count = evaluationsOfStep * std::max(1.0, errorTime / parameters.timeStep);
    return tuning.roundingDrift * 0x1p-24 * maxCoordinate * std::sqrt(count);
  };
  if (tuning.doubleCost * evaluations <= budget) {
    return rounding(evaluations) > options.errorTolerance;
  }
  // The tolerance is out of reach. Fewer evaluations in double may still be more accurate than more in float.
  const double inDouble = budget / tuning.doubleCost;
  if (memory.forceEvaluations <= 0.0 || inDouble < std::max(tuning.minEvaluations, need.evaluations)) {
    return false;
  }
  const double inFloat = std::min(evaluations, budget);
  if (takesFourthOrder(inFloat, model, parameters, inputs) && !takesFourthOrder(inDouble, model, parameters, inputs)) {
    return false;
  }
  const auto schemeError = [&](double evaluationsOfStep) {
    const double ratio = memory.forceEvaluations / evaluationsOfStep;
    return options.errorTolerance * ratio * ratio;
  };
  return schemeError(inDouble) < schemeError(inFloat) + rounding(inFloat);
}

double medianStiffnessScale(const LocalRates& rates, const CommonParameters& parameters, const StepPlan& plan) {
  return stiffnessScaleAt(rates.median, parameters, plan);
}

}  // namespace drape::sim::adaptive
