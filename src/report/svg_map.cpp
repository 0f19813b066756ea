#include "report/svg.hpp"
#include "report/svg_ink.hpp"
#include "report/svg_picture.hpp"
#include "report/xml_writer.hpp"

#include <algorithm>
#include <cstddef>

namespace drape::report {
namespace {

constexpr double widestCell = 62.0;
constexpr double narrowestCell = 30.0;
constexpr double widestGrid = 806.0;  // so that a page need not shrink the picture
constexpr double cellHeight = 24.0;
constexpr double left = 170.0;
constexpr double top = 66.0;
constexpr double legendEntry = 160.0;

Ink inkOf(Tone tone) {
  switch (tone) {
    case Tone::Good:
      return Ink::Good;
    case Tone::Doubtful:
      return Ink::Doubtful;
    case Tone::Bad:
      return Ink::Bad;
    case Tone::Dull:
      return Ink::Dull;
    case Tone::None:
      break;
  }
  return Ink::None;
}

std::string pixel(double value) {
  return std::to_string(static_cast<int>(value));
}

void drawText(XmlWriter& svg, const std::string& text, const char* anchor, double x, double y) {
  svg.text("text", text, {{"text-anchor", anchor}, {"x", pixel(x)}, {"y", pixel(y)}});
}

double cellWidthOf(const StateMap& map) {
  const auto columns = static_cast<double>(std::max<std::size_t>(map.columns.size(), 1));
  return std::clamp(widestGrid / columns, narrowestCell, widestCell);
}

void drawCell(XmlWriter& svg, const MapState& state, double cellWidth, double x, double y) {
  svg.open("g");
  svg.text("title", state.name);
  const Ink ink = inkOf(state.tone);
  svg.empty("rect", {{"class", fillClass(ink)},
                     {"fill", lightColour(ink)},
                     {"x", pixel(x)},
                     {"y", pixel(y)},
                     {"width", pixel(cellWidth - 2.0)},
                     {"height", pixel(cellHeight - 2.0)}});
  drawText(svg, state.letter, "middle", x + 0.5 * cellWidth - 1.0, y + 16.0);
  svg.close();
}

void drawRows(XmlWriter& svg, const StateMap& map) {
  const double cellWidth = cellWidthOf(map);
  double y = top;
  for (const StateMap::Row& row : map.rows) {
    drawText(svg, row.label, "end", left - 8.0, y + 16.0);
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      drawCell(svg, map.states.at(static_cast<std::size_t>(row.cells[i])), cellWidth,
               left + cellWidth * static_cast<double>(i), y);
    }
    y += cellHeight;
  }
}

void drawLegend(XmlWriter& svg, const StateMap& map, double y) {
  double x = 10.0;
  for (const MapState& state : map.states) {
    drawCell(svg, state, widestCell, x, y);
    drawText(svg, state.name, "start", x + widestCell + 4.0, y + 16.0);
    x += legendEntry;
  }
}

}  // namespace

std::string svgOf(const StateMap& map) {
  const double cellWidth = cellWidthOf(map);
  const double grid = left + cellWidth * static_cast<double>(map.columns.size()) + 10.0;
  const double width = std::max(grid, 10.0 + legendEntry * static_cast<double>(map.states.size()));
  const double bottom = top + cellHeight * static_cast<double>(map.rows.size());
  const double height = bottom + 12.0 + cellHeight;
  XmlWriter svg;
  openPicture(svg, map.title, pixel(width), pixel(height), "10");
  drawText(svg, map.columnsTitle, "start", left, 40.0);
  for (std::size_t i = 0; i < map.columns.size(); ++i) {
    drawText(svg, map.columns[i], "middle", left + cellWidth * (static_cast<double>(i) + 0.5) - 1.0, 58.0);
  }
  drawRows(svg, map);
  drawLegend(svg, map, bottom + 8.0);
  return svg.take();
}

}  // namespace drape::report
