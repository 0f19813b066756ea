#pragma once

#include "settings/settings_table.hpp"
#include "text/sentence.hpp"

#include <string>

namespace drape::ui {

/// The value of a setting for the user, in few digits and without its unit: "150", "Cotton, changed", "on".
[[nodiscard]] text::Sentence shownValue(const settings::SettingInfo& info, const settings::Settings& settings);

/// The same with its unit: "150 N/m".
[[nodiscard]] text::Sentence valueInWords(const settings::SettingInfo& info, const settings::Settings& settings);

/// A text with its unit, unless that is "-", a pure number.
[[nodiscard]] text::Sentence withUnit(text::Sentence text, std::string_view unit);

}  // namespace drape::ui
