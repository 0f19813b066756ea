#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace drape::report {

/// The contents of a section of the report, as plain data. The writers (report_html.cpp, report_markdown.cpp) convert
/// them to their format; sections are independent of the formats.

struct Paragraph {
  std::string text;
};

enum class Tone { Good, Doubtful, Bad, Dull, None };

/// Every row has as many fields as the header. The first column names the row, the others hold numbers or words.
struct TextTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  bool folded = false;  ///< a long detail table: HTML shows it on demand, Markdown omits it
  /// One a row, or empty. HTML writes a row with Tone::Bad in red, Markdown in bold; the row must say it in words too.
  std::vector<Tone> tones = {};
};

/// Whether a column holds words, which are aligned left, and not numbers: the first column, and those whose fields
/// mostly begin with a letter.
[[nodiscard]] bool holdsWords(const TextTable& table, std::size_t column);

/// Whether a row of the table has Tone::Bad.
[[nodiscard]] bool isBad(const TextTable& table, std::size_t row);

enum class Scale { Linear, Logarithmic };

struct PlotAxis {
  std::string label;  ///< with the unit
  Scale scale = Scale::Linear;
};

/// The marker of a point.
enum class Mark { Filled, Hollow, Cross };

/// A point of a curve. A point that is not a number (or not positive on a logarithmic axis) is omitted and interrupts
/// the curve. A point with infinite y is drawn at the upper edge, beside the curve.
struct PlotPoint {
  double x = 0.0;
  double y = 0.0;
  Mark mark = Mark::Filled;
  std::string note = {};  ///< shown on hovering
  /// The band around the curve at this x; none when these are not numbers.
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

enum class CurveStyle {
  Line,   ///< with markers, in its own colour or grey
  Front,  ///< broad and pale below the others, without markers
  Level   ///< a dashed line across the plot at the height of its first valid point
};

struct Curve {
  std::string label;
  std::vector<PlotPoint> points;
  CurveStyle style = CurveStyle::Line;
  /// Where a plot has more lines than `maxHighlighted`, those with the largest importance stand out; of equal ones the
  /// first. The others are grey.
  double importance = 0.0;
};

/// The number of lines of a plot that stand out.
inline constexpr int maxHighlighted = 6;

struct Plot {
  std::string name;  ///< of its file: letters, digits, '-' and '_'
  std::string title;
  PlotAxis x;
  PlotAxis y;
  std::vector<Curve> curves;
};

/// The curve of a plot with that label. Appends one without points if there is none.
[[nodiscard]] Curve& curveLabelled(const std::string& label, Plot& plot);

/// A state of a cell of a map.
struct MapState {
  std::string name;
  std::string letter;
  Tone tone = Tone::None;
};

/// Coloured cells with letters. `cells` are indices into `states`, one per column.
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

/// Shaded surfaces side by side, as they are seen from one direction.
struct Drawing {
  /// A triangle of a surface on the picture.
  struct Face {
    std::array<double, 3> x{};  ///< to the right [m]
    std::array<double, 3> y{};  ///< upwards [m]
    double light = 1.0;         ///< 0 (dark) to 1 (bright)
  };
  struct Panel {
    std::string caption;
    std::vector<Face> faces;  ///< those behind first
  };
  std::string name;  ///< as of a Plot
  std::string title;
  double halfWidth = 0.1;  ///< of a panel, around its origin [m]
  std::vector<Panel> panels;
};

using Block = std::variant<Paragraph, TextTable, Plot, StateMap, Drawing>;

}  // namespace drape::report
