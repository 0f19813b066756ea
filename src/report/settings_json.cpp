#include "report/settings_json.hpp"

#include "settings/settings_table.hpp"

#include <string>

namespace drape {

nlohmann::ordered_json settingsJson(const Settings& settings) {
  nlohmann::ordered_json json;
  for (const SettingInfo& info : settingsTable()) {
    std::visit([&](const auto& value) { json[std::string(info.key)] = value; }, settingValue(settings, info));
  }
  return json;
}

}  // namespace drape
