#include "sim/adaptive/stretch_choice.hpp"

#include "sim/adaptive/settling.hpp"
#include "sim/adaptive/step_plan.hpp"
#include "sim/adaptive/tuning.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/forces/stability.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace drape::sim::adaptive {
namespace {

/// An estimate of the strain of a material under weight and wind with its full stiffness [-]. Without pins the cloth
/// hangs from anywhere, by half of its size.
double strainByLoad(const fabric::Material& material, const LocalRates& rates, const CommonParameters& parameters) {
  const double width = rates.pinnedLength > 0.0 ? rates.pinnedLength : 2.0 * rates.area / rates.diagonal;
  return loadOf(rates, parameters) / (fabric::minStretchModulus(material) * width);
}

/// Levels from a stiffness to half of it.
constexpr double levelsOfHalving = 2.0;

/// The number of levels by which the stiffness may fall while a strain stays below the limit. Negative: it must rise.
int levelsBelow(double strain, double limit) {
  constexpr double tiny = 1e-12;
  return static_cast<int>(std::floor(levelsOfHalving * std::log2(limit / std::max(strain, tiny))));
}

std::vector<int> levelsOf(const std::vector<StretchMemory>& materials) {
  std::vector<int> levels;
  std::ranges::transform(materials, std::back_inserter(levels), &StretchMemory::level);
  return levels;
}

/// The strain after tuning.strainForecastTime if it continues to grow at its present rate [-].
double forecastOf(double strain, double earlierStrain, double interval) {
  return strain + std::max(0.0, strain - earlierStrain) / interval * tuning.strainForecastTime;
}

/// Stores the strain that remains after a rise of the stiffness as imposed.
/// @return false if it is too early to know
bool updateImposedStrain(double limit, double time, bool mayBeImposed, StretchMemory& memory) {
  if (memory.raisedFrom > 0.0 && mayBeImposed && memory.strain <= memory.raisedFrom) {
    if (time - memory.changed < tuning.strainSettlingTime) {
      return false;
    }
    if (memory.strain > tuning.imposedStrainFraction * memory.raisedFrom) {
      memory.imposed = memory.strain;
    }
  }
  memory.raisedFrom = 0.0;
  memory.imposed = memory.strain < limit ? 0.0 : std::min(memory.imposed, memory.strain);
  return true;
}

/// The number of levels by which the stiffness of a material may fall, 0 if the strain has not allowed a lower
/// stiffness for long enough. Raises the stiffness if the strain exceeds the limit or soon will.
/// @param forecast of memory.strain [-]
int raiseOrAllowFall(double limit, double time, double forecast, bool mayBeImposed, StretchMemory& memory) {
  if (!updateImposedStrain(limit, time, mayBeImposed, memory)) {
    return 0;
  }
  const double strain = memory.strain - memory.imposed;
  memory.peak = std::max(memory.peak, strain);
  const double expected = forecast - memory.imposed;
  if (expected > limit && memory.level > 0) {
    memory.raisedFrom = strain > limit ? memory.strain : 0.0;
    const int rise = std::clamp(-levelsBelow(expected, limit), 1, tuning.maxStretchRise);
    memory.level = std::max(0, memory.level - rise);
    memory.changed = time;
    memory.peak = 0.0;
  } else if (tuning.strainMargin * strain / StretchChoice::scaleOf(1) > limit) {
    memory.changed = time;
    memory.peak = 0.0;
  } else if (time - memory.changed > tuning.strainCalmTime) {
    return std::max(0, levelsBelow(tuning.strainMargin * memory.peak, limit));
  }
  return 0;
}

}  // namespace

double StretchChoice::scaleOf(int level) {
  return std::exp2(-level / levelsOfHalving);
}

StretchChoice::Softer StretchChoice::softerOf(const ClothModel& model) {
  Softer softer{.stiffest = fabric::withTighterRateLimit(model, tuning.maxTriangleRatio),
                .models = {},
                .rates = localRatesOf(model),
                .vertexRates = std::vector<VertexRates>(model.vertexMass.size())};
  const ClothModel& stiffest = softer.stiffest ? *softer.stiffest : model;
  const std::vector<double> none(model.fabric->materials.list().size(), scaleOf(tuning.maxStretchLevel));
  const std::vector<double> full = localRatesOf(stiffest).frequencySquared;
  const std::vector<double> soft = localRatesOf(*fabric::withStretchScales(stiffest, none)).frequencySquared;
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    for (const int v : model.triangles[t]) {
      softer.vertexRates[v] = {full[v], std::min(soft[v], full[v]), model.fabric->materials.indexOf(t)};
    }
  }
  return softer;
}

/// The highest omega^2 of each material at these levels [1/s^2]. omega^2 of a vertex is linear in the stretch moduli.
std::vector<double> StretchChoice::highestRates(const Softer& softer, const Levels& levels) {
  std::vector<double> highest(levels.size(), 0.0);
  std::vector<double> scales;
  std::ranges::transform(levels, std::back_inserter(scales), scaleOf);
  for (const VertexRates& vertex : softer.vertexRates) {
    const double rate = vertex.soft + scales[vertex.material] * (vertex.full - vertex.soft);
    highest[vertex.material] = std::max(highest[vertex.material], rate);
  }
  return highest;
}

const ClothModel& StretchChoice::at(Softer& softer, const ClothModel& model, const Levels& levels) {
  constexpr std::size_t maxModels = 12;
  const ClothModel& stiffest = softer.stiffest ? *softer.stiffest : model;
  if (std::ranges::all_of(levels, [](int level) { return level == 0; })) {
    return stiffest;
  }
  if (!softer.models.contains(levels) && softer.models.size() == maxModels) {
    softer.models.clear();
  }
  std::shared_ptr<const ClothModel>& made = softer.models[levels];
  if (!made) {
    std::vector<double> scales;
    std::ranges::transform(levels, std::back_inserter(scales), scaleOf);
    made = fabric::withStretchScales(stiffest, scales);
  }
  return *made;
}

/// The next lower levels of those materials that may fall, if that makes a step cheaper and a step costs too much.
/// Materials on which the substeps do not depend keep their level. The cost of contact is not in the budget and rises
/// with the stiffness, so with bodies a step always costs too much.
StretchChoice::Levels StretchChoice::loweredOnce(const Softer& softer, const ClothModel& model,
                                                 const StretchConditions& conditions, const Levels& levels,
                                                 const std::vector<bool>& mayFall) {
  const auto& [parameters, options, meetsBodies, isAttached] = conditions;
  const std::vector<double> rates = highestRates(softer, levels);
  const double highest = std::ranges::max(rates);
  if (!meetsBodies) {
    const ClothModel& stiffest = softer.stiffest ? *softer.stiffest : model;
    const double stiffestRate = std::ranges::max(highestRates(softer, Levels(levels.size(), 0)));
    const double evaluations = stableEvaluations(stiffest, parameters) * std::sqrt(highest / stiffestRate);
    if (evaluations <= evaluationsInBudget(model, parameters, options)) {
      return levels;
    }
  }
  constexpr double gain = tuning.minStretchGain * tuning.minStretchGain;
  Levels lower = levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    lower[i] += mayFall[i] && rates[i] > gain * highest && levels[i] < tuning.maxStretchLevel ? 1 : 0;
  }
  return std::ranges::max(highestRates(softer, lower)) < gain * highest ? lower : levels;
}

/// Lowers the levels as long as that makes a step cheaper and a step costs too much.
/// @param falls by how many levels the stiffness of each material may fall
StretchChoice::Levels StretchChoice::lowered(const Softer& softer, const ClothModel& model,
                                             const StretchConditions& conditions, const Levels& levels,
                                             const Levels& falls) {
  Levels lowest = levels;
  while (true) {
    std::vector<bool> mayFall;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      mayFall.push_back(lowest[i] < levels[i] + falls[i]);
    }
    const Levels lower = loweredOnce(softer, model, conditions, lowest, mayFall);
    if (lower == lowest) {
      return lowest;
    }
    lowest = lower;
  }
}

StretchChoice::Levels StretchChoice::firstLevels(const Softer& softer, const ClothModel& model,
                                                 const StretchConditions& conditions) {
  Levels falls;
  for (const fabric::Material& material : model.fabric->materials.list()) {
    const double strain = tuning.suddenLoadFactor * strainByLoad(material, softer.rates, conditions.parameters);
    falls.push_back(std::max(0, levelsBelow(strain, conditions.options.strainLimit)));
  }
  return lowered(softer, model, conditions, Levels(falls.size(), 0), falls);
}

void StretchChoice::update(const Softer& softer, const ClothModel& model, const StretchConditions& conditions,
                           std::span<const double> forecasts, double time, StepMemory& memory) {
  const bool mayBeImposed = conditions.meetsBodies && memory.speed < tuning.maxSpeedOfImposedStrain;
  Levels falls;
  for (std::size_t i = 0; i < memory.stretch.size(); ++i) {
    falls.push_back(
        raiseOrAllowFall(conditions.options.strainLimit, time, forecasts[i], mayBeImposed, memory.stretch[i]));
  }
  if (std::ranges::max(falls) == 0 || isSettling(memory)) {
    return;
  }
  const Levels lower = lowered(softer, model, conditions, levelsOf(memory.stretch), falls);
  for (std::size_t i = 0; i < lower.size(); ++i) {
    StretchMemory& material = memory.stretch[i];
    if (lower[i] > material.level) {
      material = {.level = lower[i], .strain = material.strain, .imposed = material.imposed, .changed = time};
    }
  }
}

void StretchChoice::measureAndUpdate(const Softer& softer, const ClothModel& model, const StretchConditions& conditions,
                                     const ClothState& state, StepMemory& memory) {
  const double interval = state.time - memory.strainsMeasured;
  memory.strainsMeasured = state.time;
  const std::vector<double> strains = fabric::strainsAlongYarns(model, state.positions);
  std::vector<double> forecasts = strains;
  for (std::size_t i = 0; i < strains.size(); ++i) {
    if (interval > 0.0) {
      forecasts[i] = forecastOf(strains[i], memory.stretch[i].strain, interval);
    }
    memory.stretch[i].strain = strains[i];
  }
  update(softer, model, conditions, forecasts, state.time, memory);
}

const ClothModel& StretchChoice::choose(const ClothModel& model, const StretchConditions& conditions,
                                        const ClothState& state, StepMemory& memory) {
  Softer& softer = softer_.get(model, softerOf);
  const std::size_t materials = model.fabric->materials.list().size();
  if (memory.sleepFingerprint != 0) {
    memory.stretch.resize(materials);
    return at(softer, model, levelsOf(memory.stretch));
  }
  if (memory.stretch.size() != materials) {
    memory.stretch.clear();
    for (const int level : firstLevels(softer, model, conditions)) {
      memory.stretch.push_back({.level = level, .changed = state.time});
    }
    memory.strainsMeasured = state.time;
  }
  const double interval = conditions.isAttached ? 0.0 : tuning.strainCheckInterval;
  if (state.time >= memory.strainsMeasured + interval || state.time < memory.strainsMeasured) {
    measureAndUpdate(softer, model, conditions, state, memory);
  }
  return at(softer, model, levelsOf(memory.stretch));
}

}  // namespace drape::sim::adaptive
