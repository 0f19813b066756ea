#include "ui/slider_range.hpp"

#include <algorithm>
#include <cmath>

namespace drape::ui {
namespace {

constexpr double wideLinear = 40.0;  // a longer linear range is narrowed
constexpr double linearAroundZero = 20.0;
constexpr double smallestLogarithmic = 1e-4;  // the first decade of a slider that begins at zero

SliderRange logarithmicRange(const settings::NumberField& field, double defaultValue) {
  if (defaultValue > 0.0) {
    return {std::max(field.min, defaultValue * 1e-3), std::min(field.max, defaultValue * 1e3), true};
  }
  return {field.min, field.max, true};
}

SliderRange linearRange(const settings::NumberField& field, double defaultValue) {
  if (field.max < wideLinear) {
    return {field.min, field.max, false};
  }
  const double reach = defaultValue > 0.0 ? 5.0 * defaultValue : linearAroundZero;
  return {std::max(field.min, -reach), std::min(field.max, reach), false};
}

/// The smallest value on a logarithmic slider above its left end.
double floorOf(const SliderRange& range) {
  return range.min > 0.0 ? range.min : std::min(smallestLogarithmic, range.max * 1e-3);
}

}  // namespace

SliderRange commonRange(const settings::NumberField& field, double defaultValue) {
  return field.logarithmic ? logarithmicRange(field, defaultValue) : linearRange(field, defaultValue);
}

double sliderFraction(const SliderRange& range, double value) {
  const double inside = std::clamp(value, range.min, range.max);
  if (!range.logarithmic) {
    return (inside - range.min) / (range.max - range.min);
  }
  const double floor = floorOf(range);
  return inside <= floor ? 0.0 : std::log(inside / floor) / std::log(range.max / floor);
}

double sliderValue(const SliderRange& range, double fraction) {
  const double place = std::clamp(fraction, 0.0, 1.0);
  if (!range.logarithmic) {
    return range.min + place * (range.max - range.min);
  }
  if (place == 0.0) {
    return range.min;
  }
  const double floor = floorOf(range);
  return std::min(range.max, floor * std::pow(range.max / floor, place));
}

}  // namespace drape::ui
