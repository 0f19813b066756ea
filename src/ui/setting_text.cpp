#include "ui/setting_text.hpp"

#include "ui/widgets.hpp"

#include <fmt/core.h>
#include <variant>

namespace drape::ui {

text::Sentence shownValue(const settings::SettingInfo& info, const settings::Settings& settings) {
  const settings::SettingValue value = settings::settingValue(settings, info);
  if (const auto* choice = std::get_if<settings::ChoiceField>(&info.field)) {
    return settings::shownChoice(*choice, std::get<std::string>(value), settings);
  }
  if (const double* number = std::get_if<double>(&value)) {
    return text::Sentence::verbatim(fmt::format("{:.4g}", *number));
  }
  if (const bool* flag = std::get_if<bool>(&value)) {
    return text::Sentence(*flag ? "on" : "off");
  }
  return text::Sentence::verbatim(settings::formatValue(value));
}

text::Sentence valueInWords(const settings::SettingInfo& info, const settings::Settings& settings) {
  return withUnit(shownValue(info, settings), info.unit);
}

text::Sentence withUnit(text::Sentence text, std::string_view unit) {
  return unit == "-" ? text : text.append(" ", unitInWords(unit));
}

}  // namespace drape::ui
