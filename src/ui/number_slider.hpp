#pragma once

#include "settings/settings_table.hpp"
#include "ui/panel_context.hpp"
#include "ui/slider_range.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace drape::ui {

/// The edits of a widget in this frame.
struct Edit {
  bool changed = false;
  bool finished = false;  ///< the mouse button was released, or the text was confirmed
  settings::SettingValue value;
};

/// A real or whole number that a slider changes.
struct SliderInput {
  std::string key;
  SliderRange range;
  std::string format;                                     ///< printf format of the value as a double: numberFormat()
  std::function<settings::SettingValue(double)> nearest;  ///< the nearest allowed value
  /// The value of a text. Throws UsageError when it is not a number.
  std::function<settings::SettingValue(const std::string&)> typed;
};

/// The slider of a number or an integer of the table. Its values are allowed together with the other `settings`. Keeps
/// references to both arguments.
[[nodiscard]] SliderInput sliderOf(const settings::SettingInfo& info, const settings::Settings& settings,
                                   const text::Catalogue& texts = text::Catalogue());

/// Draws the slider. Ctrl+click turns it into a text field, which takes all allowed values in the notations of the
/// command line ("1/150"). A number beyond the range becomes the nearest allowed one, with a hint. It replaces ImGui's
/// slider, which loses small values of a logarithmic scale and hides the number behind its handle.
[[nodiscard]] Edit numberSlider(PanelContext& context, const SliderInput& input, const settings::SettingValue& value);

/// The nearest number within a range, for what the user has typed into another kind of field.
[[nodiscard]] double nearestInRange(double typed, double min, double max);
/// Says that a typed number became the nearest one within its range. Empty for a number within it.
/// @param title of the number in a sentence
[[nodiscard]] text::Sentence rangeNote(const char* title, double typed, double min, double max);

/// The printf format of a number with its unit: "%.4g m/s".
[[nodiscard]] std::string numberFormat(std::string_view digits, std::string_view unit);

/// The value of a typed text for a setting, clamped to the range. Throws UsageError with the reason when it is not a
/// number.
[[nodiscard]] settings::SettingValue typedValue(const settings::SettingInfo& info, const settings::Settings& settings,
                                                const std::string& text);

/// The nearest whole number that an integer setting allows.
[[nodiscard]] int nearestAllowed(const settings::IntegerField& field, double value);

}  // namespace drape::ui
