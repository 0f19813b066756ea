#include "report/axis.hpp"
#include "report/curve_inks.hpp"
#include "report/svg.hpp"
#include "report/svg_ink.hpp"
#include "report/svg_picture.hpp"
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

/// A stroke of the picture.
struct Stroke {
  Ink ink = Ink::Text;
  const char* width = "1";
  const char* opacity = "1";
  const char* dash = "none";
};

constexpr Stroke gridStroke{Ink::Faint};
constexpr Stroke tickStroke{Ink::Text, "0.7"};
constexpr Stroke levelStroke{Ink::Text, "1.2", "1", "8 5"};
constexpr Stroke frontStroke{Ink::Text, "9", "0.18"};

class PlotDrawing {
 public:
  explicit PlotDrawing(const Plot& plot)
      : plot_(plot),
        inks_(curveInks(plot)),
        x_(plot.x.scale, valuesOf(plot, true)),
        y_(plot.y.scale, valuesOf(plot, false)) {}

  std::string draw() {
    openPicture(svg_, plot_.title, pixel(left + width + legendGap + legendWidth), pixel(top + height + below),
                pixel(left));
    drawAxes();
    // Fronts are drawn below the others, and grey curves below coloured ones.
    for (const int layer : {0, 1, 2}) {
      for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
        if (layerOf(i) == layer) {
          drawCurve(i);
        }
      }
    }
    drawLegend();
    return svg_.take();
  }

 private:
  [[nodiscard]] double xOf(double value) const { return left + width * x_.share(value); }
  [[nodiscard]] double yOf(double value) const { return top + height * (1.0 - y_.share(value)); }
  [[nodiscard]] bool isGrey(std::size_t index) const { return inks_[index].ink == Ink::Grey; }
  [[nodiscard]] int layerOf(std::size_t index) const {
    return plot_.curves[index].style == CurveStyle::Front ? 0 : isGrey(index) ? 1 : 2;
  }

  void line(const Stroke& stroke, Place from, Place to) {
    svg_.empty("line", {{"class", lineClass(stroke.ink)},
                        {"stroke", lightColour(stroke.ink)},
                        {"stroke-width", stroke.width},
                        {"stroke-dasharray", stroke.dash},
                        {"x1", pixel(from.x)},
                        {"y1", pixel(from.y)},
                        {"x2", pixel(to.x)},
                        {"y2", pixel(to.y)}});
  }

  void path(const Stroke& stroke, const std::string& places) {
    svg_.empty("path", {{"class", lineClass(stroke.ink)},
                        {"fill", "none"},
                        {"stroke", lightColour(stroke.ink)},
                        {"stroke-width", stroke.width},
                        {"stroke-opacity", stroke.opacity},
                        {"stroke-dasharray", stroke.dash},
                        {"stroke-linejoin", "round"},
                        {"d", places}});
  }

  void area(Ink ink, const char* opacity, const std::string& outline) {
    svg_.empty("path",
               {{"class", fillClass(ink)}, {"fill", lightColour(ink)}, {"fill-opacity", opacity}, {"d", outline}});
  }

  void drawAxes() {
    constexpr double small = 5.0;
    const double bottom = top + height;
    for (const Tick& tick : x_.ticks()) {
      const double x = xOf(tick.value);
      const bool minor = tick.label.empty();
      line(minor ? tickStroke : gridStroke, {x, bottom}, {x, minor ? bottom - small : top});
      label(tick.label, {x, bottom + 16.0}, "middle");
    }
    for (const Tick& tick : y_.ticks()) {
      const double y = yOf(tick.value);
      const bool minor = tick.label.empty();
      line(minor ? tickStroke : gridStroke, {left, y}, {minor ? left + small : left + width, y});
      label(tick.label, {left - 7.0, y + 4.0}, "end");
    }
    path({}, pathText({{left, top}, {left + width, top}, {left + width, bottom}, {left, bottom}}) + "Z");
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

  [[nodiscard]] Stroke strokeOf(std::size_t index) const {
    if (plot_.curves[index].style != CurveStyle::Line) {
      return plot_.curves[index].style == CurveStyle::Front ? frontStroke : levelStroke;
    }
    const CurveInk& ink = inks_[index];
    return {ink.ink,
            isGrey(index)          ? "1"
            : ink.ink == Ink::Auto ? "2.6"
                                   : "1.6",
            "1", ink.variant == 0 ? "none" : "7 3"};
  }

  void drawLevel(const Curve& curve) {
    for (const PlotPoint& point : curve.points) {
      if (y_.takes(point.y)) {
        const double y = yOf(point.y);
        line(levelStroke, {left, y}, {left + width, y});
        return;
      }
    }
  }

  void drawCurve(std::size_t index) {
    const Curve& curve = plot_.curves[index];
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
        drawPath(index, places);
        places.clear();
      }
    }
    drawPath(index, places);
    for (const PlotPoint& point : curve.points) {
      if (curve.style == CurveStyle::Line && x_.takes(point.x)) {
        drawMark(point, index);
      }
    }
  }

  /// Grey curves show their names on hovering, since the legend does not have them.
  void drawPath(std::size_t index, const std::vector<Place>& places) {
    if (places.size() < 2) {
      return;
    }
    svg_.open("g");
    if (isGrey(index)) {
      svg_.text("title", plot_.curves[index].label);
    }
    path(strokeOf(index), pathText(places));
    svg_.close();
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
    if (lower.size() > 1 && !isGrey(index)) {
      area(inks_[index].ink, "0.2", pathText(outline) + "Z");
    }
  }

  void drawMark(const PlotPoint& point, std::size_t index) {
    const bool beyond = point.y > 0.0 && std::isinf(point.y);
    if (!beyond && !y_.takes(point.y)) {
      return;
    }
    const Place place{xOf(point.x), beyond ? top + 6.0 : yOf(point.y)};
    svg_.open("g");
    const std::string& note = point.note.empty() && isGrey(index) ? plot_.curves[index].label : point.note;
    if (!note.empty()) {
      svg_.text("title", note);
    }
    mark(point.mark, place, index);
    svg_.close();
  }

  void mark(Mark kind, Place place, std::size_t index) {
    const double radius = isGrey(index) ? 2.4 : 4.0;
    const Ink ink = inks_[index].ink;
    if (kind == Mark::Cross) {
      path({ink, isGrey(index) ? "1" : "1.8"},
           pathText({{place.x - radius, place.y - radius}, {place.x + radius, place.y + radius}}) +
               pathText({{place.x - radius, place.y + radius}, {place.x + radius, place.y - radius}}));
      return;
    }
    const bool hollow = kind == Mark::Hollow;
    const std::string classes = hollow ? fillClass(Ink::Paper) + " " + lineClass(ink) : fillClass(ink);
    const std::string fill = lightColour(hollow ? Ink::Paper : ink);
    const std::string stroke = hollow ? lightColour(ink) : "none";
    const double size = hollow ? radius : radius - 0.6;
    if (inks_[index].variant == 0) {
      svg_.empty("circle", {{"class", classes},
                            {"fill", fill},
                            {"stroke", stroke},
                            {"stroke-width", "1.6"},
                            {"cx", pixel(place.x)},
                            {"cy", pixel(place.y)},
                            {"r", pixel(size)}});
    } else {
      // A second curve of the same colour has squares.
      svg_.empty("rect", {{"class", classes},
                          {"fill", fill},
                          {"stroke", stroke},
                          {"stroke-width", "1.6"},
                          {"x", pixel(place.x - size)},
                          {"y", pixel(place.y - size)},
                          {"width", pixel(2.0 * size)},
                          {"height", pixel(2.0 * size)}});
    }
  }

  /// Grey curves share one entry.
  void drawLegend() {
    const double begin = left + width + legendGap;
    double y = top + 8.0;
    const auto sample = [&](const Stroke& stroke) { path(stroke, pathText({{begin, y}, {begin + 26.0, y}})); };
    const auto name = [&](const std::string& text) {
      label(text, {begin + 34.0, y + 4.0}, "start");
      y += lineHeight;
    };
    int greyOnes = 0;
    for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
      if (isGrey(i)) {
        ++greyOnes;
        continue;
      }
      sample(strokeOf(i));
      if (plot_.curves[i].style == CurveStyle::Line) {
        mark(Mark::Filled, {begin + 13.0, y}, i);
      }
      name(plot_.curves[i].label);
    }
    if (greyOnes > 0) {
      sample({Ink::Grey});
      name(std::to_string(greyOnes) + (greyOnes == 1 ? " other (see its tooltip)" : " others (see their tooltips)"));
    }
  }

  const Plot& plot_;
  std::vector<CurveInk> inks_;
  Axis x_;
  Axis y_;
  XmlWriter svg_;
};

}  // namespace

std::string svgOf(const Plot& plot) {
  return PlotDrawing(plot).draw();
}

}  // namespace drape::report
