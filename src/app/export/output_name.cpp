#include "app/export/output_name.hpp"

#include "settings/settings_table.hpp"

#include <algorithm>

namespace drape::app {
namespace {

std::string valueInName(const settings::Settings& settings, const settings::SettingInfo& info) {
  std::string value = settings::formatValue(settings::settingValue(settings, info));
  std::ranges::replace_if(
      value, [](char c) { return c == '/' || c == '\0' || c == '{' || c == '}'; }, '_');
  return value;
}

}  // namespace

std::string withSettings(std::string_view pattern, const settings::Settings& settings) {
  std::string name;
  while (!pattern.empty()) {
    const std::size_t open = pattern.find('{');
    name += pattern.substr(0, open);
    if (open == std::string_view::npos) {
      break;
    }
    const std::size_t close = std::min(pattern.find('}', open), pattern.size() - 1);
    const std::string_view word = pattern.substr(open + 1, close - open - 1);
    const settings::SettingInfo* setting = settings::findSetting(word);
    name += setting == nullptr ? std::string(pattern.substr(open, close - open + 1)) : valueInName(settings, *setting);
    pattern.remove_prefix(close + 1);
  }
  return name;
}

std::string withCloth(std::string pattern, std::string_view name) {
  constexpr std::string_view placeholder = "{cloth}";
  for (std::size_t at = 0; (at = pattern.find(placeholder, at)) != std::string::npos; at += name.size()) {
    pattern.replace(at, placeholder.size(), name);
  }
  return pattern;
}

}  // namespace drape::app
