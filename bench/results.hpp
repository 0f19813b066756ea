#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drape::bench {

/// The target of a figure.
struct Bound {
  enum class Side { AtMost, AtLeast } side = Side::AtMost;
  double value = 0.0;

  [[nodiscard]] bool holds(double figure) const { return side == Side::AtMost ? figure <= value : figure >= value; }
};

/// A line of the table.
struct Row {
  std::string group;
  std::string name;
  std::string unit;  ///< "us/step"; for a time the part before the slash is ns, us, ms or s
  std::optional<Bound> bound = std::nullopt;
};

/// The quotient of two rows, both given as "group/name".
struct Ratio {
  std::string group;
  std::string name;
  std::string numerator;
  std::string denominator;
  std::optional<Bound> bound = std::nullopt;
};

/// Statistics of the repetitions of one benchmark. For a ratio: the ratio of the minima and of the medians.
struct Statistics {
  double minimum = 0.0;
  double median = 0.0;
  double low = 0.0;   ///< 10 % are below
  double high = 0.0;  ///< 10 % are above
  int count = 0;      ///< 0 for a ratio, which has no spread
};

[[nodiscard]] Statistics statisticsOf(std::vector<double> values);

/// For the unit of a row, e.g. 1e6 for "us/step".
[[nodiscard]] double unitsPerSecond(std::string_view unit);

/// The results of a run.
struct Results {
  struct Line {
    Row row;
    Statistics statistics;
  };
  std::vector<Line> lines;

  /// Appends the ratios whose two rows exist.
  void addRatios(const std::vector<Ratio>& ratios);

  /// The table, with "met" or "missed" for rows with a target. A target is met if minimum and median both meet it.
  [[nodiscard]] std::string markdown() const;

  /// The same as JSON, with a description of the machine.
  [[nodiscard]] std::string json() const;
};

}  // namespace drape::bench
