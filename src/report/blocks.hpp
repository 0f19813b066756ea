#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace drape {

/// What a section of the report shows, as plain data. The writers (report_html.cpp, report_markdown.cpp) turn any of
/// it into their format; a section knows of none.

struct Paragraph {
  std::string text;
};

/// Every row has as many fields as the header. The first column names the row, the others hold figures or words.
struct TextTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  bool folded = false;  ///< long, and not what one reads first: HTML opens it on demand, Markdown leaves it out
};

/// Whether a column holds words, which line up on the left, and not numbers: the first one does, and those of whose
/// fields most begin with a letter.
[[nodiscard]] bool holdsWords(const TextTable& table, std::size_t column);

enum class Scale { Linear, Logarithmic };

struct PlotAxis {
  std::string label;  ///< with the unit
  Scale scale = Scale::Linear;
};

/// How a point is drawn.
enum class Mark { Filled, Hollow, Cross };

/// A point of a curve. One that has no place (not a number, or not positive on a logarithmic axis) is left out and
/// interrupts the curve; one whose y is infinite stands at the upper edge, beside the curve.
struct PlotPoint {
  double x = 0.0;
  double y = 0.0;
  Mark mark = Mark::Filled;
  std::string note = {};  ///< shown where one points at it
  /// What the band around the curve reaches from and to at this x; none where they are not numbers.
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

enum class CurveStyle {
  Line,   ///< with marks, in a colour of its own
  Front,  ///< broad and pale beneath the others, without marks
  Level   ///< a dashed line from edge to edge at the height of its first point that has one
};

struct Curve {
  std::string label;
  std::vector<PlotPoint> points;
  CurveStyle style = CurveStyle::Line;
};

struct Plot {
  std::string name;  ///< of its file: letters, digits, '-' and '_'
  std::string title;
  PlotAxis x;
  PlotAxis y;
  std::vector<Curve> curves;
};

enum class Tone { Good, Doubtful, Bad, Dull, None };

/// A state that a cell of a map can be in.
struct MapState {
  std::string name;
  std::string letter;
  Tone tone = Tone::None;
};

/// Coloured cells with letters. `cells` are indices into `states`, one a column.
struct StateMap {
  struct Row {
    std::string label;
    std::vector<int> cells;
  };
  std::string name;  ///< as of a Plot
  std::string title;
  std::string columnsTitle;
  std::vector<std::string> columns;
  std::vector<Row> rows;
  std::vector<MapState> states;
};

using Block = std::variant<Paragraph, TextTable, Plot, StateMap>;

}  // namespace drape
