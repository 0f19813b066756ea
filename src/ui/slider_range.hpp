#pragma once

#include "settings/settings_table.hpp"

namespace drape::ui {

/// The range of a slider: the common part of a setting's range. Other values can be typed.
struct SliderRange {
  double min = 0.0;
  double max = 1.0;
  bool logarithmic = false;
};

/// A slider over eleven decades is too coarse, so a wide range is narrowed around the default: three decades to either
/// side on a logarithmic scale, five times the default on a linear one.
[[nodiscard]] SliderRange commonRange(const settings::NumberField& field, double defaultValue);

/// The position of a value on the slider, from 0 to 1.
[[nodiscard]] double sliderFraction(const SliderRange& range, double value);

/// The value at a position of the slider; the inverse of sliderFraction(), clamped to the slider.
[[nodiscard]] double sliderValue(const SliderRange& range, double fraction);

}  // namespace drape::ui
