#include "app/session_log.hpp"

#include "app/command_json.hpp"
#include "app/fabric_json.hpp"
#include "app/vector_json.hpp"
#include "messages/error.hpp"
#include "scene/garment_on_body.hpp"
#include "scene/scene_parts.hpp"
#include "settings/settings_table.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace drape::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int formatVersion = 1;

/// Built-in scenes, garments and bodies keep their names. A file gets an absolute name, so that the log can be replayed
/// from any folder.
std::string absoluteName(const std::string& name) {
  const auto scenes = scene::sceneList();
  const bool builtIn =
      scene::isBuiltInWear(name) ||
      std::any_of(scenes.begin(), scenes.end(), [&](const scene::SceneInfo& scene) { return scene.name == name; });
  return name.empty() || builtIn ? name : std::filesystem::absolute(name).string();
}

scene::SceneParts absoluteParts(scene::SceneParts parts) {
  parts.scene = absoluteName(parts.scene);
  parts.cloth = absoluteName(parts.cloth);
  for (std::string& body : parts.bodies) {
    body = absoluteName(body);
  }
  for (std::string& cache : parts.caches) {
    cache = absoluteName(cache);
  }
  return parts;
}

Json toJson(const scene::Placement& placement) {
  return {{"position", vectorJson(placement.position)},
          {"rotation", vectorJson(placement.rotation)},
          {"scale", placement.scale}};
}

Json toJson(const std::vector<scene::Placement>& placements) {
  Json list = Json::array();
  for (const scene::Placement& placement : placements) {
    list.push_back(toJson(placement));
  }
  return list;
}

scene::Placement placementFrom(const Json& json) {
  return {vectorFrom(json.at("position")), vectorFrom(json.at("rotation")), json.at("scale").get<double>()};
}

std::vector<scene::Placement> placementsFrom(const Json& json) {
  std::vector<scene::Placement> placements;
  for (const Json& each : json) {
    placements.push_back(placementFrom(each));
  }
  return placements;
}

Json toJson(const scene::ReadingChoice& reading) {
  return {{"unit", reading.unit}, {"up", reading.up}};
}

Json toJson(const std::vector<std::optional<scene::ReadingChoice>>& readings) {
  Json list = Json::array();
  for (const std::optional<scene::ReadingChoice>& reading : readings) {
    list.push_back(reading ? toJson(*reading) : Json(nullptr));
  }
  return list;
}

scene::ReadingChoice readingFrom(const Json& json) {
  return {json.at("unit"), json.at("up")};
}

/// Logs of earlier versions have no readings.
std::vector<std::optional<scene::ReadingChoice>> readingsFrom(const Json& json) {
  std::vector<std::optional<scene::ReadingChoice>> readings;
  for (const Json& each : json) {
    readings.emplace_back();
    if (!each.is_null()) {
      readings.back() = readingFrom(each);
    }
  }
  return readings;
}

Json toJson(const std::vector<std::optional<std::string>>& clips) {
  Json list = Json::array();
  for (const std::optional<std::string>& clip : clips) {
    list.push_back(clip ? Json(*clip) : Json(nullptr));
  }
  return list;
}

/// Logs of earlier versions have no clips.
std::vector<std::optional<std::string>> clipsFrom(const Json& json) {
  std::vector<std::optional<std::string>> clips;
  for (const Json& each : json) {
    clips.push_back(each.is_null() ? std::nullopt : std::optional(each.get<std::string>()));
  }
  return clips;
}

SessionLog parse(const Json& json) {
  SessionLog log;
  if (json.at("drape_session") != formatVersion) {
    throw messages::InputError("it was written by another version of Drape");
  }
  log.parts.scene = json.at("scene");
  log.parts.cloth = json.at("cloth");
  log.parts.bodies = json.at("bodies");
  log.parts.caches = json.value("caches", std::vector<std::string>());
  log.parts.dressed = json.value("dressed", false);
  for (const Json& each : json.value("body_readings", Json::array())) {
    log.parts.bodyReadings.push_back(readingFrom(each));
  }
  log.parts.bodyClips = clipsFrom(json.value("clips", Json::array()));
  for (const auto& [key, value] : json.at("settings").items()) {
    log.settings.emplace_back(key, value.get<std::string>());
  }
  log.fabrics = fabricsFrom(json.value("fabrics", Json::array()));
  if (const auto found = json.find("placements"); found != json.end()) {
    log.placements = {placementsFrom(found->at("cloths")), placementsFrom(found->at("bodies")),
                      readingsFrom(found->value("readings", Json::array())),
                      clipsFrom(found->value("clips", Json::array()))};
  }
  for (const Json& entry : json.at("commands")) {
    log.commands.push_back(commandFrom(entry));
  }
  log.steps = json.at("steps");
  log.stateHash = json.at("state_hash");
  return log;
}

void requireOrder(const SessionLog& log) {
  constexpr std::int64_t maxSteps = 1'000'000'000;
  std::int64_t before = 0;
  for (const session::LoggedCommand& entry : log.commands) {
    if (entry.step < before) {
      throw messages::InputError("the steps of its commands must not decrease (step " + std::to_string(entry.step) +
                                 " after " + std::to_string(before) + ")");
    }
    before = entry.step;
  }
  if (log.steps < before || log.steps > maxSteps) {
    throw messages::InputError("\"steps\" must be from " + std::to_string(before) + " to " + std::to_string(maxSteps) +
                               ", not " + std::to_string(log.steps));
  }
}

/// The settings of a scene under those of the log. A wrong one is a fault of the file, not of the command line.
settings::Settings loggedSettings(const SessionLog& log, settings::Settings settings) {
  settings.fabric.own = settings::joined(settings.fabric.own, log.fabrics);
  try {
    // First the settings that decide others: mass and density decide mass_given_as, a preset decides the fabric.
    for (int depth = settings::maxDepth; depth >= 0; --depth) {
      for (const auto& [key, value] : log.settings) {
        const settings::SettingInfo& info = settings::requireSetting(key);
        if (settings::depthOf(info) == depth) {
          settings::assignSettingText(settings, info, value);
        }
      }
    }
    settings::requireConsistent(settings);
  } catch (const messages::UsageError& error) {
    throw messages::InputError(log.file + ": " + error.what());
  }
  return settings;
}

}  // namespace

SessionLog sessionLogOf(const session::Simulation& simulation) {
  SessionLog log;
  const scene::SceneDescription& description = simulation.scene().description;
  log.parts = absoluteParts(description.parts);
  const bool hasReadings = std::ranges::any_of(
      description.bodies, [](const scene::BodyDescription& body) { return body.reading.has_value(); });
  if (hasReadings || scene::placementsOf(description) != scene::writtenPlacementsOf(description)) {
    log.placements = scene::placementsOf(description);
  }
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    log.settings.emplace_back(info.key,
                              settings::formatValue(settings::settingValue(simulation.scene().settings, info)));
  }
  log.fabrics = simulation.scene().settings.fabric.own;
  log.commands = simulation.log();
  log.steps = simulation.stepsTaken();
  log.stateHash = sim::toHex(sim::stateHash(simulation.state()));
  return log;
}

void write(const SessionLog& log, OutputFile& file) {
  Json json;
  json["drape_session"] = formatVersion;
  json["scene"] = log.parts.scene;
  json["cloth"] = log.parts.cloth;
  json["bodies"] = log.parts.bodies;
  json["caches"] = log.parts.caches;
  json["dressed"] = log.parts.dressed;
  json["body_readings"] = Json::array();
  for (const scene::ReadingChoice& reading : log.parts.bodyReadings) {
    json["body_readings"].push_back(toJson(reading));
  }
  json["clips"] = toJson(log.parts.bodyClips);
  for (const auto& [key, value] : log.settings) {
    json["settings"][key] = value;
  }
  json["fabrics"] = toJson(log.fabrics);
  if (log.placements) {
    json["placements"]["cloths"] = toJson(log.placements->cloths);
    json["placements"]["bodies"] = toJson(log.placements->bodies);
    json["placements"]["readings"] = toJson(log.placements->readings);
    json["placements"]["clips"] = toJson(log.placements->clips);
  }
  json["commands"] = Json::array();
  for (const session::LoggedCommand& entry : log.commands) {
    json["commands"].push_back(toJson(entry));
  }
  json["steps"] = log.steps;
  json["state_hash"] = log.stateHash;
  file.write(json);
}

SessionLog readSessionLog(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) {
    throw messages::InputError("cannot read the session log " + file + "; check the name");
  }
  try {
    SessionLog log = parse(Json::parse(text));
    log.file = file;
    requireOrder(log);
    return log;
  } catch (const messages::InputError& error) {
    throw messages::InputError(file + ": " + error.what());
  } catch (const Json::exception&) {
    throw messages::InputError(file + " is not a complete session log; 'drape --record FILE' writes one");
  }
}

std::shared_ptr<const scene::Scene> openLoggedScene(const SessionLog& log) {
  scene::SceneDescription description = scene::openParts(log.parts, log.fabrics);
  if (log.placements) {
    try {
      description = scene::withPlacements(std::move(description), *log.placements);
    } catch (const messages::InputError& error) {
      throw messages::InputError(log.file + ": " + error.what());
    }
  }
  return scene::buildScene(description, loggedSettings(log, description.settings));
}

}  // namespace drape::app
