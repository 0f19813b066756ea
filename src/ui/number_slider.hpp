#pragma once

#include "settings/settings_table.hpp"
#include "ui/panel_context.hpp"
#include "ui/slider_range.hpp"

#include <functional>
#include <string>

namespace drape {

/// How a widget was edited in this frame.
struct Edit {
  bool changed = false;
  bool finished = false;  ///< the mouse let go, or the text was confirmed
  SettingValue value;
};

/// A number that a slider changes.
struct NumberInput {
  std::string key;
  std::function<SettingValue(double)> nearest;            ///< the nearest value that is allowed
  std::function<SettingValue(const std::string&)> typed;  ///< what a text means; throws UsageError when it is no number
};

/// A setting, under the settings in force.
[[nodiscard]] NumberInput inputOf(const SettingInfo& info, const Settings& settings);

/// A slider for a real or a whole number, over `range`, whose value reads as `format` prints a double. Ctrl+click turns
/// it into a text field, which takes all that is allowed and the same notations as the command line ("1/150"); a
/// number beyond the range becomes the nearest that is allowed. It replaces ImGui's slider because that one loses small
/// values of a logarithmic scale and hides the number behind its handle.
[[nodiscard]] Edit numberSlider(PanelContext& context, const NumberInput& input, const SliderRange& range,
                                const SettingValue& value, const std::string& format);

/// What typed text means for a setting: the value, clamped when it is a number beyond the range. Throws UsageError,
/// with the reason in words, when it is no number.
[[nodiscard]] SettingValue typedValue(const SettingInfo& info, const Settings& settings, const std::string& text);

/// The nearest whole number that an integer setting takes.
[[nodiscard]] int nearestAllowed(const IntegerField& field, double value);

}  // namespace drape
