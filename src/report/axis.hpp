#pragma once

#include "report/blocks.hpp"

#include <string>
#include <vector>

namespace drape::report {

struct Tick {
  double value = 0.0;
  std::string label;  ///< empty: a small tick between two others
};

/// The axis of a plot.
class Axis {
 public:
  /// An axis for these values. It extends to the next tick on either side, on a logarithmic axis to the next decade.
  /// Values that cannot be drawn do not count; without any it runs from 0 to 1, or 1 to 10.
  Axis(Scale scale, const std::vector<double>& values);

  /// Whether the value can be drawn.
  [[nodiscard]] bool takes(double value) const;

  /// The position of a drawable value, from 0 at the lower end to 1 at the upper end.
  [[nodiscard]] double share(double value) const;

  /// In ascending order, all within the axis. At least two have labels.
  [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  void makeLinear(double lowest, double highest);
  void makeLogarithmic(double lowest, double highest);

  Scale scale_;
  double begin_ = 0.0;  // of the value, or of its decimal logarithm
  double end_ = 1.0;
  std::vector<Tick> ticks_;
};

}  // namespace drape::report
