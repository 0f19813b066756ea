#include "report/axis.hpp"
#include "report/svg.hpp"
#include "report/xml_writer.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace drape::report {
namespace {

constexpr double left = 72.0;
constexpr double top = 36.0;
constexpr double width = 560.0;   // of the frame
constexpr double height = 380.0;  // of the frame
constexpr double legendGap = 16.0;
constexpr double legendWidth = 250.0;
constexpr double lineHeight = 17.0;
constexpr double below = 54.0;
constexpr int colours = 8;
constexpr int dashes = 4;

/// Tenths of a pixel are precise enough and keep the files short.
std::string pixel(double value) {
  return fmt::format("{:.1f}", static_cast<double>(std::llround(10.0 * value)) / 10.0);
}

struct Place {
  double x = 0.0;
  double y = 0.0;
};

std::string pathText(const std::vector<Place>& places) {
  std::string path;
  for (const Place& place : places) {
    path += (path.empty() ? "M" : "L") + pixel(place.x) + " " + pixel(place.y);
  }
  return path;
}

std::vector<double> valuesOf(const Plot& plot, bool horizontal) {
  std::vector<double> values;
  for (const Curve& curve : plot.curves) {
    for (const PlotPoint& point : curve.points) {
      if (horizontal) {
        values.push_back(point.x);
      } else {
        values.insert(values.end(), {point.y, point.low, point.high});
      }
    }
  }
  return values;
}

class PlotDrawing {
 public:
  explicit PlotDrawing(const Plot& plot)
      : plot_(plot), x_(plot.x.scale, valuesOf(plot, true)), y_(plot.y.scale, valuesOf(plot, false)) {}

  std::string draw() {
    const double legendHeight = lineHeight * static_cast<double>(plot_.curves.size()) + top + 8.0;
    const double whole = std::max(top + height + below, legendHeight);
    svg_.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                      {"class", "drape"},
                      {"role", "img"},
                      {"width", pixel(left + width + legendGap + legendWidth)},
                      {"height", pixel(whole)},
                      {"viewBox", "0 0 " + pixel(left + width + legendGap + legendWidth) + " " + pixel(whole)}});
    svg_.text("title", plot_.title);
    svg_.text("text", plot_.title, {{"class", "title"}, {"x", pixel(left)}, {"y", "20"}});
    drawAxes();
    // Fronts are drawn below the others, independent of their order.
    for (const bool front : {true, false}) {
      for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
        if ((plot_.curves[i].style == CurveStyle::Front) == front) {
          drawCurve(plot_.curves[i], i);
        }
      }
    }
    drawLegend();
    return svg_.take();
  }

 private:
  [[nodiscard]] double xOf(double value) const { return left + width * x_.share(value); }
  [[nodiscard]] double yOf(double value) const { return top + height * (1.0 - y_.share(value)); }

  void line(const char* style, Place from, Place to) {
    svg_.empty(
        "line",
        {{"class", style}, {"x1", pixel(from.x)}, {"y1", pixel(from.y)}, {"x2", pixel(to.x)}, {"y2", pixel(to.y)}});
  }

  void drawAxes() {
    constexpr double small = 5.0;
    const double bottom = top + height;
    for (const Tick& tick : x_.ticks()) {
      const double x = xOf(tick.value);
      line(tick.label.empty() ? "small" : "grid", {x, bottom}, {x, tick.label.empty() ? bottom - small : top});
      label(tick.label, {x, bottom + 16.0}, "middle");
    }
    for (const Tick& tick : y_.ticks()) {
      const double y = yOf(tick.value);
      line(tick.label.empty() ? "small" : "grid", {left, y}, {tick.label.empty() ? left + small : left + width, y});
      label(tick.label, {left - 7.0, y + 4.0}, "end");
    }
    svg_.empty("rect", {{"class", "frame"},
                        {"x", pixel(left)},
                        {"y", pixel(top)},
                        {"width", pixel(width)},
                        {"height", pixel(height)}});
    label(plot_.x.label, {left + 0.5 * width, bottom + 40.0}, "middle");
    const std::string middle = pixel(top + 0.5 * height);
    svg_.text("text", plot_.y.label,
              {{"text-anchor", "middle"}, {"x", "16"}, {"y", middle}, {"transform", "rotate(-90 16 " + middle + ")"}});
  }

  void label(const std::string& text, Place place, const char* anchor) {
    if (!text.empty()) {
      svg_.text("text", text, {{"text-anchor", anchor}, {"x", pixel(place.x)}, {"y", pixel(place.y)}});
    }
  }

  static std::string styleOf(const Curve& curve, std::size_t index) {
    if (curve.style != CurveStyle::Line) {
      return curve.style == CurveStyle::Front ? "front" : "level";
    }
    const std::string dash = std::to_string(index / colours % dashes);
    return "curve line" + std::to_string(index % colours) + " dash" + dash;
  }

  void drawLevel(const Curve& curve) {
    for (const PlotPoint& point : curve.points) {
      if (y_.takes(point.y)) {
        const double y = yOf(point.y);
        line("level", {left, y}, {left + width, y});
        return;
      }
    }
  }

  void drawCurve(const Curve& curve, std::size_t index) {
    if (curve.style == CurveStyle::Level) {
      drawLevel(curve);
      return;
    }
    drawBand(curve, index);
    std::vector<Place> places;
    for (const PlotPoint& point : curve.points) {
      if (x_.takes(point.x) && y_.takes(point.y)) {
        places.push_back({xOf(point.x), yOf(point.y)});
      } else if (!(point.y > 0.0 && std::isinf(point.y))) {
        drawPath(curve, index, places);
        places.clear();
      }
    }
    drawPath(curve, index, places);
    for (const PlotPoint& point : curve.points) {
      if (curve.style == CurveStyle::Line && x_.takes(point.x)) {
        drawMark(point, index);
      }
    }
  }

  void drawPath(const Curve& curve, std::size_t index, const std::vector<Place>& places) {
    if (places.size() > 1) {
      svg_.empty("path", {{"class", styleOf(curve, index)}, {"d", pathText(places)}});
    }
  }

  void drawBand(const Curve& curve, std::size_t index) {
    std::vector<Place> outline;
    std::vector<Place> lower;
    for (const PlotPoint& point : curve.points) {
      if (x_.takes(point.x) && y_.takes(point.low) && y_.takes(point.high)) {
        outline.push_back({xOf(point.x), yOf(point.high)});
        lower.push_back({xOf(point.x), yOf(point.low)});
      }
    }
    outline.insert(outline.end(), lower.rbegin(), lower.rend());
    if (lower.size() > 1) {
      svg_.empty("path", {{"class", "band fill" + std::to_string(index % colours)}, {"d", pathText(outline) + "Z"}});
    }
  }

  void drawMark(const PlotPoint& point, std::size_t index) {
    const bool beyond = point.y > 0.0 && std::isinf(point.y);
    if (!beyond && !y_.takes(point.y)) {
      return;
    }
    const Place place{xOf(point.x), beyond ? top + 6.0 : yOf(point.y)};
    svg_.open("g");
    if (!point.note.empty()) {
      svg_.text("title", point.note);
    }
    mark(point.mark, place, index);
    svg_.close();
  }

  void mark(Mark kind, Place place, std::size_t index) {
    constexpr double radius = 4.0;
    const std::string number = std::to_string(index % colours);
    if (kind == Mark::Cross) {
      const std::string path = pathText({{place.x - radius, place.y - radius}, {place.x + radius, place.y + radius}}) +
                               pathText({{place.x - radius, place.y + radius}, {place.x + radius, place.y - radius}});
      svg_.empty("path", {{"class", "cross line" + number}, {"d", path}});
      return;
    }
    const std::string style = (kind == Mark::Filled ? "fill" : "hollow line") + number;
    const double size = kind == Mark::Filled ? radius - 0.6 : radius;
    // When colours repeat, marks change their shape and lines their dashes.
    switch (index / colours % dashes) {
      case 0:
        svg_.empty("circle", {{"class", style}, {"cx", pixel(place.x)}, {"cy", pixel(place.y)}, {"r", pixel(size)}});
        break;
      case 1:
        polygon(style, {{place.x - size, place.y - size},
                        {place.x + size, place.y - size},
                        {place.x + size, place.y + size},
                        {place.x - size, place.y + size}});
        break;
      case 2:
        polygon(style, {{place.x, place.y - 1.3 * size},
                        {place.x + 1.3 * size, place.y + size},
                        {place.x - 1.3 * size, place.y + size}});
        break;
      default:
        polygon(style, {{place.x, place.y - 1.4 * size},
                        {place.x + 1.4 * size, place.y},
                        {place.x, place.y + 1.4 * size},
                        {place.x - 1.4 * size, place.y}});
    }
  }

  void polygon(const std::string& style, const std::vector<Place>& corners) {
    svg_.empty("path", {{"class", style}, {"d", pathText(corners) + "Z"}});
  }

  void drawLegend() {
    const double begin = left + width + legendGap;
    double y = top + 8.0;
    for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
      const Curve& curve = plot_.curves[i];
      svg_.empty("path", {{"class", styleOf(curve, i)}, {"d", pathText({{begin, y}, {begin + 26.0, y}})}});
      if (curve.style == CurveStyle::Line) {
        mark(Mark::Filled, {begin + 13.0, y}, i);
      }
      label(curve.label, {begin + 34.0, y + 4.0}, "start");
      y += lineHeight;
    }
  }

  const Plot& plot_;
  Axis x_;
  Axis y_;
  XmlWriter svg_;
};

}  // namespace

std::string svgOf(const Plot& plot) {
  return PlotDrawing(plot).draw();
}

}  // namespace drape::report
