#include "sim/adaptive/stretch_choice.hpp"

#include "sim/adaptive/step_plan.hpp"
#include "sim/adaptive/tuning.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/forces/forces.hpp"
#include "sim/forces/stability.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::adaptive {
namespace {

/// An estimate of the strain under weight and wind with the full stiffness [-]. Without pins the cloth hangs from
/// anywhere, by half of its size.
double strainByLoad(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters) {
  const double width = rates.pinnedLength > 0.0 ? rates.pinnedLength : 2.0 * rates.area / rates.diagonal;
  return loadOf(rates, parameters) / (stretchStiffness(model, parameters) * width);
}

/// Levels from a stiffness to half of it.
constexpr double levelsOfHalving = 2.0;

/// By how many levels the stiffness may fall while a strain stays below the limit. Negative: it must rise.
int levelsBelow(double strain, double limit) {
  constexpr double tiny = 1e-12;
  return static_cast<int>(std::floor(levelsOfHalving * std::log2(limit / std::max(strain, tiny))));
}

}  // namespace

double StretchChoice::scaleOf(int level) {
  return std::exp2(-level / levelsOfHalving);
}

StretchChoice::Levels StretchChoice::levelsOf(const ClothModel& model) {
  Levels levels{.models = std::vector<std::shared_ptr<const ClothModel>>(tuning.maxStretchLevel + 1),
                .rates = localRatesOf(model)};
  levels.models.front() = fabric::withTighterRateLimit(model, tuning.maxTriangleRatio);
  return levels;
}

const ClothModel& StretchChoice::at(Levels& levels, const ClothModel& model, int level) {
  const ClothModel& stiffest = levels.models.front() ? *levels.models.front() : model;
  if (level == 0) {
    return stiffest;
  }
  std::shared_ptr<const ClothModel>& softer = levels.models[static_cast<std::size_t>(level)];
  if (!softer) {
    softer = fabric::withStretchScale(stiffest, scaleOf(level));
  }
  return *softer;
}

/// Whether the next lower stiffness makes a step cheaper, and a step costs too much. The cost of contact is not in the
/// budget and rises with the stiffness, so with bodies a step always costs too much.
bool StretchChoice::isLowerWorthwhile(Levels& levels, const ClothModel& model, const StretchConditions& conditions,
                                      int level) {
  const auto& [parameters, options, meetsBodies, isAttached] = conditions;
  if (level >= tuning.maxStretchLevel) {
    return false;
  }
  const double evaluations = stableEvaluations(at(levels, model, level), parameters);
  if (!meetsBodies && evaluations <= evaluationsInBudget(model, parameters, options)) {
    return false;
  }
  return stableEvaluations(at(levels, model, level + 1), parameters) < tuning.minStretchGain * evaluations;
}

int StretchChoice::firstLevel(Levels& levels, const ClothModel& model, const StretchConditions& conditions) {
  const double strain = strainByLoad(model, levels.rates, conditions.parameters);
  const int allowed = levelsBelow(strain, conditions.options.strainLimit);
  int level = 0;
  while (level < allowed && isLowerWorthwhile(levels, model, conditions, level)) {
    ++level;
  }
  return level;
}

void StretchChoice::update(Levels& levels, const ClothModel& model, const StretchConditions& conditions, double time,
                           double speed, StretchMemory& memory) {
  const double limit = conditions.options.strainLimit;
  const bool mayBeImposed = conditions.meetsBodies && speed < tuning.maxSpeedOfImposedStrain;
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
    memory.level = std::max(0, memory.level + std::min(-1, levelsBelow(strain, limit)));
    memory.changed = time;
  } else if (tuning.strainMargin * strain / scaleOf(1) > limit) {
    memory.changed = time;
  } else if (time - memory.changed > tuning.strainCalmTime &&
             isLowerWorthwhile(levels, model, conditions, memory.level)) {
    ++memory.level;
    memory.changed = time;
  }
}

const ClothModel& StretchChoice::choose(const ClothModel& model, const StretchConditions& conditions,
                                        const ClothState& state, StepMemory& memory) {
  Levels& levels = levels_.get(model, levelsOf);
  StretchMemory& stretch = memory.stretch;
  if (memory.sleepFingerprint != 0) {
    return at(levels, model, std::max(0, stretch.level));
  }
  if (stretch.level < 0) {
    stretch.level = firstLevel(levels, model, conditions);
    stretch.changed = stretch.checked = state.time;
  }
  const double interval = conditions.isAttached ? 0.0 : tuning.strainCheckInterval;
  if (state.time >= stretch.checked + interval || state.time < stretch.checked) {
    stretch.checked = state.time;
    stretch.strain = fabric::strainAlongYarns(model, state.positions);
    update(levels, model, conditions, state.time, memory.speed, stretch);
  }
  return at(levels, model, stretch.level);
}

}  // namespace drape::sim::adaptive
