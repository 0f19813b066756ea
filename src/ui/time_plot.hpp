#pragma once

#include "ui/measure_history.hpp"
#include "ui/panel_context.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace drape::ui {

/// One curve over simulated time, and its row in the legend.
struct PlotCurve {
  std::string_view name;
  ImVec4 colour;
  std::optional<double> (*value)(const MeasureSample&);  ///< empty: a gap
};

/// Round numbers that cover a range, for grid lines and labels.
struct PlotScale {
  double low = 0.0;   ///< a multiple of step
  double high = 1.0;  ///< a multiple of step, above low
  double step = 1.0;  ///< 1, 2 or 5 times a power of ten
};

/// The scale that covers `low` to `high` and zero, with at most `maxSteps` steps.
[[nodiscard]] PlotScale plotScale(double low, double high, int maxSteps);

/// Draws the curves with a scale, a line at zero and the time axis, then a legend with the newest values. Ignores
/// values that are not finite.
void timePlot(const PanelContext& context, std::string_view title, std::string_view unit,
              std::span<const MeasureSample> samples, std::span<const PlotCurve> curves);

}  // namespace drape::ui
