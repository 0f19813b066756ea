#include "report/svg.hpp"
#include "report/svg_picture.hpp"
#include "report/xml_writer.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cstddef>

namespace drape::report {
namespace {

constexpr double panelWidth = 250.0;
constexpr double panelHeight = 190.0;
constexpr double panelTop = 34.0;
constexpr double captionHeight = 24.0;
constexpr std::size_t panelsOfLine = 4;

/// A grey blue of this lightness.
std::string fillOf(double light) {
  const double share = std::clamp(light, 0.0, 1.0);
  return fmt::format("#{:02x}{:02x}{:02x}", static_cast<int>(40.0 + 180.0 * share),
                     static_cast<int>(55.0 + 180.0 * share), static_cast<int>(85.0 + 165.0 * share));
}

void drawFace(XmlWriter& svg, const Drawing::Face& face, double scale, double x, double y) {
  std::string points;
  for (std::size_t i = 0; i < face.x.size(); ++i) {
    points += fmt::format("{}{:.1f},{:.1f}", i == 0 ? "" : " ", x + scale * face.x[i], y - scale * face.y[i]);
  }
  // The stroke covers the gaps that smoothing leaves between faces.
  const std::string fill = fillOf(face.light);
  svg.empty("polygon", {{"points", points}, {"fill", fill}, {"stroke", fill}, {"stroke-width", "0.6"}});
}

}  // namespace

std::string svgOf(const Drawing& drawing) {
  const std::size_t columns = std::clamp<std::size_t>(drawing.panels.size(), 1, panelsOfLine);
  const std::size_t lines = (drawing.panels.size() + panelsOfLine - 1) / panelsOfLine;
  const std::string width = fmt::format("{:.0f}", panelWidth * static_cast<double>(columns));
  const std::string height =
      fmt::format("{:.0f}", panelTop + (panelHeight + captionHeight) * static_cast<double>(lines));
  XmlWriter svg;
  openPicture(svg, drawing.title, width, height, "10");
  const double scale = 0.48 * panelWidth / drawing.halfWidth;
  for (std::size_t i = 0; i < drawing.panels.size(); ++i) {
    const double left = panelWidth * static_cast<double>(i % panelsOfLine);
    const std::size_t line = i / panelsOfLine;
    const double top = panelTop + (panelHeight + captionHeight) * static_cast<double>(line);
    for (const Drawing::Face& face : drawing.panels[i].faces) {
      drawFace(svg, face, scale, left + 0.5 * panelWidth, top + 0.45 * panelHeight);
    }
    svg.text("text", drawing.panels[i].caption,
             {{"text-anchor", "middle"},
              {"x", fmt::format("{:.0f}", left + 0.5 * panelWidth)},
              {"y", fmt::format("{:.0f}", top + panelHeight + 14.0)}});
  }
  return svg.take();
}

}  // namespace drape::report
