#include "app/fabric_json.hpp"

#include "settings/settings_table.hpp"

namespace drape::app {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json toJson(const settings::OwnFabric& fabric) {
  settings::Settings values;
  settings::useFabric(values, fabric);
  Json json{{"name", fabric.name}, {"based_on", fabric.basedOn}, {"source", fabric.source}};
  for (const std::string_view key : settings::fabricValueKeys()) {
    json[std::string(key)] = std::get<double>(settings::settingValue(values, settings::requireSetting(key)));
  }
  return json;
}

Json toJson(const settings::OwnFabrics& fabrics) {
  Json json = Json::array();
  for (const settings::OwnFabric& fabric : fabrics ? *fabrics : std::vector<settings::OwnFabric>()) {
    json.push_back(toJson(fabric));
  }
  return json;
}

settings::OwnFabric fabricFrom(const Json& json) {
  settings::Settings values;
  for (const std::string_view key : settings::fabricValueKeys()) {
    settings::assignSetting(values, settings::requireSetting(key), json.at(std::string(key)).get<double>());
  }
  settings::OwnFabric fabric = settings::fabricOf(values, json.at("name").get<std::string>());
  fabric.basedOn = json.at("based_on").get<std::string>();
  fabric.source = json.at("source").get<std::string>();
  return fabric;
}

settings::OwnFabrics fabricsFrom(const Json& json) {
  settings::OwnFabrics fabrics;
  for (const Json& each : json) {
    fabrics = settings::withOwnFabric(fabrics, fabricFrom(each));
  }
  return fabrics;
}

}  // namespace drape::app
