#include "fields/colour_range.hpp"

#include "sim/model/quantile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace drape::fields {
namespace {

constexpr std::size_t oneIn = 200;   // may lie outside the range
constexpr double second = 1.0;       // after which a range may shrink [s]
constexpr double muchSmaller = 0.6;  // part of a range that the values may fill before it shrinks [-]

/// How far the values extend from the neutral one, on its upper side or on both.
double extentOf(const sim::fields::FieldInfo& field, std::span<const double> values) {
  std::vector<double> extents;
  extents.reserve(values.size());
  for (const double value : values) {
    if (std::isfinite(value)) {
      const double beyond = value - field.neutral;
      extents.push_back(field.hasSign ? std::abs(beyond) : std::max(0.0, beyond));
    }
  }
  return sim::quantileExceededBy(extents, oneIn);
}

}  // namespace

double roundedUp(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  constexpr std::array factors{1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0};
  constexpr double rounding = 1.0 + 1e-9;
  for (const double factor : factors) {
    if (value <= factor * power * rounding) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

ColourRange AutomaticRange::update(const sim::fields::FieldInfo& field, std::span<const double> values, double time) {
  const double extent = std::max(field.minExtent, extentOf(field, values));
  const bool starts = field_ != &field || time < secondBegan_;
  if (starts) {
    field_ = &field;
    extent_ = 0.0;
  }
  if (starts || time - secondBegan_ >= second) {
    extent_ = largest_ < muchSmaller * extent_ ? roundedUp(std::max(largest_, extent)) : extent_;
    largest_ = 0.0;
    secondBegan_ = time;
  }
  largest_ = std::max(largest_, extent);
  if (extent > extent_) {
    extent_ = roundedUp(extent);
  }
  return {field.hasSign ? field.neutral - extent_ : field.neutral, field.neutral + extent_};
}

}  // namespace drape::fields
