#pragma once

#include <vector>

namespace drape::figure {

/// A value at a share of the period.
struct CurveKey {
  double phase = 0.0;  ///< 0 to 1 [-]
  double value = 0.0;
};

/// A smooth curve of period 1 through keys: cubic Hermite curves with the slope of the chord between the neighbours
/// (Catmull and Rom 1974), so that its first derivative is continuous.
class PeriodicCurve {
 public:
  /// @param keys at least three, phases ascending and below 1
  explicit PeriodicCurve(std::vector<CurveKey> keys) : keys_(std::move(keys)) {}

  [[nodiscard]] double at(double phase) const;

 private:
  [[nodiscard]] CurveKey key(int index) const;
  [[nodiscard]] double slope(int index) const;

  std::vector<CurveKey> keys_;
};

/// The part of a number above the integer below it, 0 to 1.
[[nodiscard]] double fractionOf(double number);

/// Rises from 0 at 0 to 1 at 1, level at both and constant outside.
[[nodiscard]] double smoothStep(double t);

}  // namespace drape::figure
