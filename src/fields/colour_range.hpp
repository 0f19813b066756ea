#pragma once

#include "sim/fields/field_table.hpp"

#include <span>

namespace drape::fields {

/// The values at the ends of a colour map.
struct ColourRange {
  double low = 0.0;
  double high = 1.0;

  /// 0 at the low end, 1 at the high end.
  [[nodiscard]] double placeOf(double value) const { return (value - low) / (high - low); }

  friend bool operator==(const ColourRange&, const ColourRange&) = default;
};

/// A range that follows the values of a field but stays steady. Its ends are round numbers. It covers all but one value
/// in 200, so that a few extreme vertices do not make the rest look alike. It grows at once. It shrinks when all values
/// of the last second of simulated time fit into a much smaller range.
class AutomaticRange {
 public:
  /// @param values in the unit of the field; NaN and infinite ones do not count  @param time simulated [s]
  ColourRange update(const sim::fields::FieldInfo& field, std::span<const double> values, double time);

 private:
  const sim::fields::FieldInfo* field_ = nullptr;
  double extent_ = 0.0;       // of the range, on one side of the neutral value
  double largest_ = 0.0;      // extent of the values since secondBegan_
  double secondBegan_ = 0.0;  // simulated [s]
};

/// The smallest number of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten that is not below a positive value.
[[nodiscard]] double roundedUp(double value);

}  // namespace drape::fields
