#include "report/settings_json.hpp"

#include "settings/settings_table.hpp"

#include <string>

namespace drape::report {

nlohmann::ordered_json settingsJson(const settings::Settings& settings) {
  nlohmann::ordered_json json;
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    std::visit([&](const auto& value) { json[std::string(info.key)] = value; }, settings::settingValue(settings, info));
  }
  return json;
}

}  // namespace drape::report
