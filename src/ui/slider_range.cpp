#include "ui/slider_range.hpp"

#include <algorithm>
#include <cmath>

namespace drape {
namespace {

constexpr double wideLinear = 40.0;  // a linear range beyond this is narrowed
constexpr double linearAroundZero = 20.0;
constexpr double decadesBelowMax = 1e-6;  // where a logarithmic slider starts when nothing else says so

SliderRange logarithmicRange(const NumberField& field, double defaultValue) {
  if (defaultValue > 0.0) {
    return {std::max(field.min, defaultValue * 1e-3), std::min(field.max, defaultValue * 1e3), true};
  }
  // From zero: ImGui puts the zero itself at the left end.
  return {field.min, field.max, true};
}

SliderRange linearRange(const NumberField& field, double defaultValue) {
  if (field.max < wideLinear) {
    return {field.min, field.max, false};
  }
  const double reach = defaultValue > 0.0 ? 5.0 * defaultValue : linearAroundZero;
  return {std::max(field.min, -reach), std::min(field.max, reach), false};
}

}  // namespace

SliderRange everydayRange(const NumberField& field, double defaultValue) {
  return field.logarithmic ? logarithmicRange(field, defaultValue) : linearRange(field, defaultValue);
}

double sliderFraction(const SliderRange& range, double value) {
  const double inside = std::clamp(value, range.min, range.max);
  if (!range.logarithmic) {
    return (inside - range.min) / (range.max - range.min);
  }
  const double floor = range.min > 0.0 ? range.min : range.max * decadesBelowMax;
  return inside <= floor ? 0.0 : std::log(inside / floor) / std::log(range.max / floor);
}

}  // namespace drape
