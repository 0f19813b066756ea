#pragma once

#include "ui/measure_history.hpp"
#include "ui/panel_context.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// One line of a plot over simulated time, and its row in the legend.
struct PlotCurve {
  std::string_view name;
  ImVec4 colour;
  std::optional<double> (*value)(const MeasureSample&);  ///< nothing: a gap
};

/// Round numbers that cover a range: for the lines of a plot and what stands beside them.
struct PlotScale {
  double low = 0.0;   ///< a multiple of step
  double high = 1.0;  ///< a multiple of step, above low
  double step = 1.0;  ///< 1, 2 or 5 times a power of ten
};

/// The scale that covers `low` to `high` with at most `most` steps, zero included.
[[nodiscard]] PlotScale plotScale(double low, double high, int most);

/// Draws the curves with a scale, a line at zero and the time below, then a legend with the newest values. Values that
/// are no finite numbers are left out.
void timePlot(const PanelContext& context, std::string_view title, std::string_view unit,
              std::span<const MeasureSample> samples, std::span<const PlotCurve> curves);

}  // namespace drape
