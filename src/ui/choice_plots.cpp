#include "ui/panels.hpp"
#include "ui/time_plot.hpp"

#include <algorithm>
#include <array>

namespace drape::ui {
namespace {

/// A curve of one of the choices per step, with gaps for steps of other solvers.
template <auto value>
std::optional<double> chosen(const MeasureSample& sample) {
  return sample.choice ? value(*sample.choice) : std::nullopt;
}

std::optional<double> substeps(const sim::adaptive::StepChoice& choice) {
  return choice.substeps;
}

std::optional<double> forceEvaluations(const sim::adaptive::StepChoice& choice) {
  return choice.forceEvaluations;
}

std::optional<double> stiffnessScale(const sim::adaptive::StepChoice& choice) {
  return 100.0 * choice.stiffnessScale;
}

std::optional<double> energyDrift(const sim::adaptive::StepChoice& choice) {
  return 1e3 * choice.energyDrift;
}

bool isSofter(const MeasureSample& sample) {
  constexpr double allOfIt = 0.995;
  return sample.choice && sample.choice->stiffnessScale < allOfIt;
}

}  // namespace

void choicePlots(const PanelContext& context) {
  const auto& colours = palette().plot;
  const auto samples = context.memory.measures.samples();
  const std::array counts{PlotCurve{"Substeps", colours[0], chosen<substeps>},
                          PlotCurve{"Force evaluations", colours[1], chosen<forceEvaluations>}};
  timePlot(context, "Chosen", context.texts("per step"), counts);
  if (std::any_of(samples.begin(), samples.end(), isSofter)) {
    const std::array kept{PlotCurve{"Stiffness scale", colours[2], chosen<stiffnessScale>}};
    timePlot(context, "Stiffness scale", "%", kept);
  }
  const std::array energy{PlotCurve{"Energy drift", colours[4], chosen<energyDrift>}};
  timePlot(context, "Energy drift", "mJ", energy);
}

}  // namespace drape::ui
