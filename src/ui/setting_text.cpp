#include "ui/setting_text.hpp"

#include "ui/widgets.hpp"

#include <fmt/core.h>
#include <variant>

namespace drape::ui {

std::string shownValue(const settings::SettingInfo& info, const settings::Settings& settings) {
  const settings::SettingValue value = settings::settingValue(settings, info);
  if (const auto* choice = std::get_if<settings::ChoiceField>(&info.field)) {
    return settings::shownChoice(*choice, std::get<std::string>(value), settings);
  }
  if (const double* number = std::get_if<double>(&value)) {
    return fmt::format("{:.4g}", *number);
  }
  return settings::formatValue(value);
}

std::string valueInWords(const settings::SettingInfo& info, const settings::Settings& settings) {
  return withUnit(shownValue(info, settings), info.unit);
}

std::string withUnit(const std::string& text, std::string_view unit) {
  return unit == "-" ? text : text + " " + prettyUnit(unit);
}

}  // namespace drape::ui
