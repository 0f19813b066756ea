#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drape::bench {

/// What a figure is held against.
struct Bound {
  enum class Side { AtMost, AtLeast } side = Side::AtMost;
  double value = 0.0;

  [[nodiscard]] bool holds(double figure) const { return side == Side::AtMost ? figure <= value : figure >= value; }
};

/// A line of the table.
struct Row {
  std::string group;
  std::string name;
  std::string unit;  ///< "us/step": what stands before the slash is ns, us, ms or s for a time
  std::optional<Bound> bound = std::nullopt;
};

/// One line over another, both named as "group/name".
struct Ratio {
  std::string group;
  std::string name;
  std::string numerator;
  std::string denominator;
  std::optional<Bound> bound = std::nullopt;
};

/// Of the repetitions of one benchmark. For a ratio: the ratio of the minima, of the medians.
struct Statistics {
  double minimum = 0.0;
  double median = 0.0;
  double low = 0.0;   ///< 10 % are below
  double high = 0.0;  ///< 10 % are above
  int count = 0;      ///< 0 for a ratio, which has no spread of its own
};

[[nodiscard]] Statistics statisticsOf(std::vector<double> values);

/// For the unit of a row, e.g. 1e6 for "us/step".
[[nodiscard]] double unitsPerSecond(std::string_view unit);

/// What a run found.
struct Results {
  struct Line {
    Row row;
    Statistics statistics;
  };
  std::vector<Line> lines;

  /// Appends the ratios whose two lines are both there.
  void addRatios(const std::vector<Ratio>& ratios);

  /// The table, a bounded line with "met" or "missed": a bound is met when minimum and median both keep to it.
  [[nodiscard]] std::string markdown() const;

  /// The same, and what machine it was found on.
  [[nodiscard]] std::string json() const;
};

}  // namespace drape::bench
