#include "ui/time_plot.hpp"

#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace drape::ui {
namespace {

constexpr double shortestSpan = 0.5;  // minimum of the time axis [s]

/// The area of the curves and its axes.
struct Frame {
  ImVec2 low;   // upper left corner
  ImVec2 high;  // lower right corner
  PlotScale scale;
  double start = 0.0;  // [s]
  double span = 1.0;   // [s]

  [[nodiscard]] float x(double time) const {
    return low.x + (high.x - low.x) * static_cast<float>((time - start) / span);
  }
  [[nodiscard]] float y(double value) const {
    return high.y - (high.y - low.y) * static_cast<float>((value - scale.low) / (scale.high - scale.low));
  }
};

std::optional<double> finiteValue(const PlotPoint& point) {
  return point.value && std::isfinite(*point.value) ? point.value : std::nullopt;
}

/// The smallest and the largest value; nothing without any.
std::optional<std::pair<double, double>> rangeOf(std::span<const PlotSeries> series) {
  std::optional<std::pair<double, double>> range;
  for (const PlotSeries& each : series) {
    for (const PlotPoint& point : each.points) {
      if (const auto value = finiteValue(point)) {
        range = range ? std::pair(std::min(range->first, *value), std::max(range->second, *value))
                      : std::pair(*value, *value);
      }
    }
  }
  return range;
}

PlotScale scaleOf(std::span<const PlotSeries> series, bool close) {
  constexpr int maxSteps = 4;
  const auto range = rangeOf(series);
  if (!range) {
    return plotScale(0.0, 0.0, maxSteps);
  }
  return close && range->first < range->second ? closePlotScale(range->first, range->second, maxSteps)
                                               : plotScale(range->first, range->second, maxSteps);
}

/// Multiples of the step. Rounding must not turn zero into 1e-17.
std::vector<double> ticksOf(const PlotScale& scale) {
  std::vector<double> ticks;
  const auto first = static_cast<long long>(std::llround(scale.low / scale.step));
  const auto last = static_cast<long long>(std::llround(scale.high / scale.step));
  for (long long i = first; i <= last; ++i) {
    ticks.push_back(static_cast<double>(i) * scale.step);
  }
  return ticks;
}

std::string tickText(double value) {
  return fmt::format("{:.6g}", value);
}

float widestTick(const PlotScale& scale) {
  float widest = 0.0F;
  for (const double tick : ticksOf(scale)) {
    widest = std::max(widest, ImGui::CalcTextSize(tickText(tick).c_str()).x);
  }
  return widest;
}

void drawScale(const PanelContext& context, const Frame& frame) {
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  canvas.AddRectFilled(frame.low, frame.high, ImGui::GetColorU32(palette().field));
  const ImU32 muted = ImGui::GetColorU32(palette().muted);
  for (const double tick : ticksOf(frame.scale)) {
    const float y = std::round(frame.y(tick));
    const bool zero = tick == 0.0;
    canvas.AddLine({frame.low.x, y}, {frame.high.x, y}, zero ? muted : ImGui::GetColorU32(palette().line),
                   std::max(1.0F, context.scale));
    const std::string text = tickText(tick);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    canvas.AddText({frame.low.x - size.x - 5.0F * context.scale, y - std::round(size.y * 0.5F)}, muted, text.c_str());
  }
  const std::string start = fmt::format("{:.3g} s", frame.start);
  const std::string end = fmt::format("{:.3g} s", frame.start + frame.span);
  const float below = frame.high.y + 3.0F * context.scale + ImGui::GetTextLineHeight() * 0.25F;
  canvas.AddText({frame.low.x, below}, muted, start.c_str());
  canvas.AddText({frame.high.x - ImGui::CalcTextSize(end.c_str()).x, below}, muted, end.c_str());
}

void drawCurve(const PanelContext& context, const Frame& frame, const PlotSeries& curve) {
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  const ImU32 colour = ImGui::GetColorU32(curve.colour);
  const auto stroke = [&] { canvas.PathStroke(colour, ImDrawFlags_None, 1.5F * context.scale); };
  for (const PlotPoint& point : curve.points) {
    if (const auto value = finiteValue(point)) {
      canvas.PathLineTo({frame.x(point.time), frame.y(*value)});
    } else {
      stroke();
    }
  }
  stroke();
}

/// A line at a time, as long as curves go on after it. Its rectangle is stored as "plot.present".
void markPresent(const PanelContext& context, const Frame& frame, double newest, double present) {
  if (present >= newest || present < frame.start) {
    return;
  }
  const float x = std::round(frame.x(present));
  ImGui::GetWindowDrawList()->AddLine({x, frame.low.y}, {x, frame.high.y}, ImGui::GetColorU32(palette().text),
                                      std::max(1.0F, context.scale));
  context.buttons["plot.present"] = {x, frame.low.y, 1.0, frame.high.y - frame.low.y};
}

/// The value at a time, or the newest one.
std::optional<double> valueAt(const PlotSeries& curve, std::optional<double> time) {
  const auto found = time ? std::ranges::find(curve.points, *time, &PlotPoint::time) : curve.points.end();
  if (found != curve.points.end()) {
    return found->value;
  }
  return curve.points.empty() ? std::nullopt : curve.points.back().value;
}

void legendRow(const PanelContext& context, const PlotSeries& curve, std::string_view unit, bool close,
               std::optional<double> present) {
  const float length = ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float y = at.y + ImGui::GetTextLineHeight() * 0.5F;
  ImGui::GetWindowDrawList()->AddLine({at.x, y}, {at.x + length, y}, ImGui::GetColorU32(curve.colour),
                                      2.5F * context.scale);
  ImGui::Indent(length * 1.5F);
  const std::optional<double> value = valueAt(curve, present);
  const auto inWords = [&](double number) {
    constexpr int digitsOfClose = 5;
    return close ? text::figure(number, digitsOfClose) + " " + std::string(unit) : text::formatQuantity(number, unit);
  };
  valueRow(context, curve.name, value ? inWords(*value) : "\u2013");
  ImGui::Unindent(length * 1.5F);
}

}  // namespace

PlotScale plotScale(double low, double high, int maxSteps) {
  return closePlotScale(std::min(low, 0.0), std::max(high, 0.0), maxSteps);
}

PlotScale closePlotScale(double low, double high, int maxSteps) {
  const double span = high - low;
  if (!(span > 0.0) || !std::isfinite(span)) {
    return {0.0, 1.0, 1.0};
  }
  const double power = std::pow(10.0, std::floor(std::log10(span / maxSteps)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
    const double step = factor * power;
    const double below = std::floor(low / step);
    const double above = std::ceil(high / step);
    if (above - below <= maxSteps) {
      return {below * step, above * step, step};
    }
  }
  return {low, high, span};
}

void timePlot(const PanelContext& context, const Wording& title, std::string_view unit,
              std::span<const PlotCurve> curves) {
  const MeasureHistory& measures = context.memory.measures;
  std::vector<PlotSeries> series;
  for (const PlotCurve& curve : curves) {
    PlotSeries& each = series.emplace_back();
    each.name = curve.name;
    each.colour = curve.colour;
    for (const MeasureSample& sample : measures.samples()) {
      each.points.push_back({sample.time, curve.value(sample)});
    }
  }
  seriesPlot(context, title, unit, series, false, measures.present());
}

void seriesPlot(const PanelContext& context, const Wording& title, std::string_view unit,
                std::span<const PlotSeries> series, bool close, std::optional<double> present) {
  ImGui::Dummy({0.0F, 2.0F * context.scale});
  mutedText(context.texts(title) + " [" + std::string(unit) + "]", palette().text);
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, std::round(line * 8.0F)};
  ImGui::Dummy(size);
  Frame frame;
  frame.scale = scaleOf(series, close);
  // Half a line of text extends above the top tick and below the lowest; the time axis is below that.
  frame.low = {std::round(at.x + widestTick(frame.scale) + 6.0F * context.scale), std::round(at.y + 0.5F * line)};
  frame.high = {at.x + size.x, std::round(at.y + size.y - 1.4F * line)};
  if (!series.empty() && !series.front().points.empty()) {
    frame.start = series.front().points.front().time;
    frame.span = std::max(shortestSpan, series.front().points.back().time - frame.start);
  }
  drawScale(context, frame);
  for (const PlotSeries& each : series) {
    drawCurve(context, frame, each);
  }
  if (present && !series.empty() && !series.front().points.empty()) {
    markPresent(context, frame, series.front().points.back().time, *present);
  }
  for (const PlotSeries& each : series) {
    legendRow(context, each, unit, close, present);
  }
}

}  // namespace drape::ui
