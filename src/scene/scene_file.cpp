#include "scene/scene_file.hpp"

#include "messages/error.hpp"
#include "scene/body_reader.hpp"
#include "scene/fabric_file.hpp"
#include "scene/framing.hpp"
#include "scene/toml_reader.hpp"
#include "settings/settings_table.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

namespace drape::scene {
namespace {

constexpr double manyDegrees = 1e6;

void readCloth(const TomlReader& cloth, const std::filesystem::path& folder, SceneDescription& scene) {
  cloth.allowOnly({"mesh", "grid", "position", "rotation", "pleats"});
  const bool mesh = cloth.has("mesh");
  const auto plane = cloth.text("grid");
  if (mesh == plane.has_value()) {
    cloth.fail("[cloth] needs either mesh = \"file.obj\" or grid = \"horizontal\" or \"vertical\"");
  }
  if (mesh) {
    scene.source = meshSource(cloth, folder);
  } else if (*plane == "horizontal" || *plane == "vertical") {
    scene.source = GridSource{*plane == "vertical" ? GridSource::Plane::Vertical : GridSource::Plane::Horizontal};
  } else {
    cloth.fail("cloth.grid must be \"horizontal\" or \"vertical\", not \"" + *plane + "\"");
  }
  scene.position = cloth.vector("position").value_or(Vec3::Zero());
  scene.rotation = degree * cloth.vector("rotation", manyDegrees).value_or(Vec3::Zero());
  if (const auto pleats = cloth.table("pleats")) {
    pleats->allowOnly({"count", "gather"});
    scene.pleats = Pleats{pleats->integer("count", 1, 1000).value_or(Pleats{}.count),
                          pleats->number("gather", 0.1, 1.0).value_or(Pleats{}.gather)};
  }
}

PinSelection readPins(const TomlReader& reader) {
  reader.allowOnly({"vertices", "nearest", "boxes", "top", "corners", "edges", "every", "body"});
  PinSelection pins;
  pins.where = reader.place();
  pins.vertices = reader.integers("vertices");
  pins.nearest = reader.vectors("nearest");
  for (const TomlReader& box : reader.tables("boxes")) {
    box.allowOnly({"min", "max"});
    pins.boxes.push_back(
        {box.vector("min").value_or(Vec3::Constant(-farAway)), box.vector("max").value_or(Vec3::Constant(farAway))});
  }
  pins.top = reader.number("top", 0.0, 1.0);
  pins.corners = reader.texts("corners");
  pins.edges = reader.texts("edges");
  pins.every = reader.integer("every", 1, 1000).value_or(1);
  pins.body = reader.text("body").value_or("");
  return pins;
}

/// Reads whether an object has contact (`solid`, by default true), and its surface.
void readSolidity(const TomlReader& table, const std::string& what, std::optional<sim::contact::Body>& body) {
  if (table.flag("solid").value_or(true)) {
    readSurface(table, *body);
    return;
  }
  body.reset();
  if (std::any_of(surfaceKeys.begin(), surfaceKeys.end(), [&](auto key) { return table.has(key); })) {
    table.fail("friction and thickness of the " + what + " need solid = true");
  }
}

std::vector<std::string_view> withSurfaceKeys(std::vector<std::string_view> keys) {
  keys.insert(keys.end(), surfaceKeys.begin(), surfaceKeys.end());
  return keys;
}

void readGround(const TomlReader& ground, SceneDescription& scene) {
  ground.allowOnly(withSurfaceKeys({"height", "solid"}));
  scene.groundHeight = ground.number("height", -farAway, farAway);
  readSolidity(ground, "ground", scene.ground);
}

StandDescription readStand(const TomlReader& reader, const std::filesystem::path& folder) {
  reader.allowOnly(withSurfaceKeys({"mesh", "solid"}));
  StandDescription stand{meshSource(reader, folder)};
  readSolidity(reader, "stand", stand.body);
  return stand;
}

CameraPose readCamera(const TomlReader& reader) {
  reader.allowOnly({"position", "focal_point", "view_angle"});
  CameraPose pose;
  pose.position = reader.vector("position").value_or(pose.position);
  pose.focalPoint = reader.vector("focal_point").value_or(pose.focalPoint);
  pose.viewAngle = reader.number("view_angle", 1.0, 150.0).value_or(pose.viewAngle);
  if ((pose.position - pose.focalPoint).norm() < minViewDistance) {
    reader.fail(fmt::format("camera.position and camera.focal_point must be at least {:.2f} m apart", minViewDistance));
  }
  return pose;
}

/// Checks that the pins' body exists.
void requireCarrier(const TomlReader& scene, const SceneDescription& description) {
  const std::string& name = description.pins.body;
  const auto& bodies = description.bodies;
  if (!name.empty() &&
      std::none_of(bodies.begin(), bodies.end(), [&](const BodyDescription& each) { return each.body.name == name; })) {
    scene.table("pins")->fail("pins.body: there is no body with the name \"" + name + "\"");
  }
}

void readSettings(const TomlReader& reader, SceneDescription& scene) {
  settings::Settings& settings = scene.settings;
  const auto assign = [&](const std::string& key, const toml::node& node, int depth) {
    try {
      const settings::SettingInfo& info = settings::requireSetting(key);
      if (settings::depthOf(info) != depth) {
        return;
      }
      // A text may also be a fraction: time_step = "1/150".
      if (const auto* text = node.as_string()) {
        settings::assignSettingText(settings, info, text->get());
      } else {
        settings::assignSetting(settings, info, settingValueOf(node));
      }
    } catch (const messages::UsageError& error) {
      reader.fail(node, error.what());
    }
  };
  // A table has no order. So a preset comes first, and single values change it.
  for (int depth = settings::maxDepth; depth >= 0; --depth) {
    reader.forEachValue([&](const std::string& key, const toml::node& node) {
      const std::string note = settings::formerKeyNote(key);
      if (depth == 0 && !note.empty()) {
        scene.notes.push_back(reader.placeOf(node) + ": " + note);
      }
      assign(key, node, depth);
    });
  }
  try {
    settings::requireConsistent(settings);
  } catch (const messages::UsageError& error) {
    reader.fail(error.what());
  }
}

}  // namespace

SceneDescription parseScene(std::string_view text, const std::string& name, const std::string& file,
                            const std::filesystem::path& folder, const settings::OwnFabrics& own) {
  const TomlReader reader(text, file);
  reader.allowOnly({"title", "help", "cloth", "pins", "camera", "stand", "ground", "bodies", "settings", "fabrics"});
  SceneDescription scene;
  scene.settings.fabric.own = settings::joined(own, readFabrics(reader));
  scene.name = name;
  scene.title = reader.text("title").value_or(name);
  scene.help = reader.text("help").value_or("");
  const auto cloth = reader.table("cloth");
  if (!cloth) {
    throw messages::InputError(file + ": a scene needs a table [cloth] with either mesh or grid");
  }
  readCloth(*cloth, folder, scene);
  if (const auto pins = reader.table("pins")) {
    scene.pins = readPins(*pins);
  }
  if (const auto camera = reader.table("camera")) {
    scene.camera = readCamera(*camera);
  }
  if (const auto stand = reader.table("stand")) {
    scene.stand = readStand(*stand, folder);
  }
  if (const auto ground = reader.table("ground")) {
    readGround(*ground, scene);
  }
  scene.bodies = readBodies(reader, folder);
  requireCarrier(reader, scene);
  if (const auto settings = reader.table("settings")) {
    readSettings(*settings, scene);
  }
  return scene;
}

}  // namespace drape::scene
