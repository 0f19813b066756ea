#pragma once

#include "settings/settings_table.hpp"
#include "ui/panel_context.hpp"
#include "ui/slider_range.hpp"

#include <functional>
#include <string>

namespace drape {

/// The edits of a widget in this frame.
struct Edit {
  bool changed = false;
  bool finished = false;  ///< the mouse button was released, or the text was confirmed
  SettingValue value;
};

/// A number that a slider changes.
struct NumberInput {
  std::string key;
  std::function<SettingValue(double)> nearest;  ///< the nearest allowed value
  std::function<SettingValue(const std::string&)>
      typed;  ///< the value of a text; throws UsageError when it is not a number
};

/// The input for a setting, with the current settings.
[[nodiscard]] NumberInput inputOf(const SettingInfo& info, const Settings& settings);

/// A slider for a real or a whole number over `range`; `format` prints its value as a double. Ctrl+click turns it into
/// a text field, which takes all allowed values in the notations of the command line ("1/150"). A number beyond the
/// range becomes the nearest allowed one. It replaces ImGui's slider, which loses small values of a logarithmic scale
/// and hides the number behind its handle.
[[nodiscard]] Edit numberSlider(PanelContext& context, const NumberInput& input, const SliderRange& range,
                                const SettingValue& value, const std::string& format);

/// The value of a typed text for a setting, clamped to the range. Throws UsageError with the reason when it is not a
/// number.
[[nodiscard]] SettingValue typedValue(const SettingInfo& info, const Settings& settings, const std::string& text);

/// The nearest whole number that an integer setting allows.
[[nodiscard]] int nearestAllowed(const IntegerField& field, double value);

}  // namespace drape
