#pragma once

#include "ui/measure_history.hpp"
#include "ui/panel_context.hpp"
#include "ui/wording.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drape::ui {

/// One curve over simulated time, and its row in the legend.
struct PlotCurve {
  std::string_view name;
  ImVec4 colour;
  std::optional<double> (*value)(const MeasureSample&);  ///< empty: a gap
};

/// One value at a time [s].
struct PlotPoint {
  double time = 0.0;
  std::optional<double> value;  ///< empty, or not finite: a gap
};

/// One curve of points in the order of time, and its row in the legend.
struct PlotSeries {
  Wording name;
  ImVec4 colour;
  std::vector<PlotPoint> points;
};

/// Round numbers that cover a range, for grid lines and labels.
struct PlotScale {
  double low = 0.0;   ///< a multiple of step
  double high = 1.0;  ///< a multiple of step, above low
  double step = 1.0;  ///< 1, 2 or 5 times a power of ten
};

/// The scale that covers `low` to `high` and zero, with at most `maxSteps` steps.
[[nodiscard]] PlotScale plotScale(double low, double high, int maxSteps);
/// The same without zero, if it is far from the values. The range must not be empty.
[[nodiscard]] PlotScale closePlotScale(double low, double high, int maxSteps);

/// Draws the curves with a scale, a line at zero and the time axis, then a legend with the newest values. Ignores
/// values that are not finite.
/// @param close whether the scale may leave out zero
/// @param present a time at which a point of each series is [s]: a line marks it where it is not the newest one, and
/// the legend has the values there
void seriesPlot(const PanelContext& context, const Wording& title, std::string_view unit,
                std::span<const PlotSeries> series, bool close = false, std::optional<double> present = std::nullopt);

/// The same for curves of the measures in the context.
void timePlot(const PanelContext& context, const Wording& title, std::string_view unit,
              std::span<const PlotCurve> curves);

}  // namespace drape::ui
