#include "sim/adaptive/stretch_choice.hpp"

#include "sim/adaptive/step_plan.hpp"
#include "sim/adaptive/tuning.hpp"
#include "sim/fabric/stretch_scale.hpp"
#include "sim/forces/forces.hpp"
#include "sim/forces/stability.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::adaptive {
namespace {

/// The force evaluations of a stable step.
double stableEvaluations(const ClothModel& model, const CommonParameters& parameters) {
  return parameters.timeStep / (tuning.comfortableFraction * verletStepLimit(model, parameters));
}

/// An estimate of the strain under weight and wind with the full stiffness [-]. Without pins the cloth hangs from
/// anywhere, by half of its size.
double strainByLoad(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters) {
  const double load = parameters.gravity * rates.mass + tuning.windLoadFraction * maxWindForce(rates, parameters);
  const double width = rates.pinnedLength > 0.0 ? rates.pinnedLength : 2.0 * rates.area / rates.diagonal;
  return load / (stretchStiffness(model, parameters) * width);
}

bool meetsBodies(const StepInputs& inputs) {
  return inputs.bodies != nullptr && !inputs.bodies->empty();
}

/// How often the stiffness may be halved while a strain stays below the limit. Negative: it must be doubled.
int halvings(double strain, double limit) {
  constexpr double tiny = 1e-12;
  return static_cast<int>(std::floor(std::log2(limit / std::max(strain, tiny))));
}

}  // namespace

double StretchChoice::scaleOf(int level) {
  return std::exp2(-level);
}

const ClothModel& StretchChoice::at(Levels& levels, const ClothModel& model, int level) {
  if (level == 0) {
    return model;
  }
  std::shared_ptr<const ClothModel>& softer = levels.models[static_cast<std::size_t>(level)];
  if (!softer) {
    softer = fabric::withStretchScale(model, scaleOf(level));
  }
  return *softer;
}

/// Whether the next lower stiffness makes a step cheaper, and a step costs too much. The cost of contact is not in the
/// budget and rises with the stiffness, so with bodies a step always costs too much.
bool StretchChoice::gainsFromLower(Levels& levels, const ClothModel& model, const CommonParameters& parameters,
                                   const AutoOptions& options, const StepInputs& inputs, int level) {
  if (level >= tuning.maxStretchLevel) {
    return false;
  }
  const double evaluations = stableEvaluations(at(levels, model, level), parameters);
  if (!meetsBodies(inputs) && evaluations <= evaluationsInBudget(model, parameters, options)) {
    return false;
  }
  return stableEvaluations(at(levels, model, level + 1), parameters) < tuning.minStretchGain * evaluations;
}

int StretchChoice::firstLevel(Levels& levels, const ClothModel& model, const CommonParameters& parameters,
                              const AutoOptions& options, const StepInputs& inputs) {
  const int allowed = halvings(strainByLoad(model, levels.rates, parameters), options.strainLimit);
  int level = 0;
  while (level < allowed && gainsFromLower(levels, model, parameters, options, inputs, level)) {
    ++level;
  }
  return level;
}

void StretchChoice::update(Levels& levels, const ClothModel& model, const CommonParameters& parameters,
                           const AutoOptions& options, const StepInputs& inputs, double time, double speed,
                           StretchMemory& memory) {
  const double limit = options.strainLimit;
  const bool mayBeImposed = meetsBodies(inputs) && speed < tuning.maxSpeedOfImposedStrain;
  if (memory.raisedFrom > 0.0 && mayBeImposed) {
    if (time - memory.changed < tuning.strainSettlingTime) {
      return;
    }
    if (memory.strain > tuning.imposedStrainFraction * memory.raisedFrom) {
      memory.imposed = memory.strain;
    }
  }
  memory.raisedFrom = 0.0;
  memory.imposed = memory.strain < limit ? 0.0 : std::min(memory.imposed, memory.strain);
  const double strain = memory.strain - memory.imposed;
  if (strain > limit && memory.level > 0) {
    memory.raisedFrom = memory.strain;
    memory.level = std::max(0, memory.level + std::min(-1, halvings(strain, limit)));
    memory.changed = time;
  } else if (2.0 * strain > limit) {
    memory.changed = time;
  } else if (time - memory.changed > tuning.strainCalmTime &&
             gainsFromLower(levels, model, parameters, options, inputs, memory.level)) {
    ++memory.level;
    memory.changed = time;
  }
}

const ClothModel& StretchChoice::choose(const ClothModel& model, const CommonParameters& parameters,
                                        const AutoOptions& options, const StepInputs& inputs, const ClothState& state,
                                        StepMemory& all) {
  StretchMemory& memory = all.stretch;
  if (options.strainLimit <= 0.0) {
    memory = {};
    return model;
  }
  Levels& levels = levels_.get(model, [](const ClothModel& own) {
    return Levels{.models = std::vector<std::shared_ptr<const ClothModel>>(tuning.maxStretchLevel + 1),
                  .rates = localRatesOf(own)};
  });
  if (memory.level < 0) {
    memory.level = firstLevel(levels, model, parameters, options, inputs);
    memory.changed = memory.checked = state.time;
  }
  const double interval = inputs.attachment ? 0.0 : tuning.strainCheckInterval;
  if (state.time >= memory.checked + interval || state.time < memory.checked) {
    memory.checked = state.time;
    memory.strain = fabric::stretchAlongYarns(model, state.positions);
    update(levels, model, parameters, options, inputs, state.time, all.speed, memory);
  }
  return at(levels, model, memory.level);
}

}  // namespace drape::sim::adaptive
