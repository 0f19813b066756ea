#include "scene/scene_file.hpp"

#include "messages/error.hpp"
#include "scene/body_reader.hpp"
#include "scene/fabric_file.hpp"
#include "scene/framing.hpp"
#include "scene/keyframe_file.hpp"
#include "scene/placement_file.hpp"
#include "scene/seam_file.hpp"
#include "scene/toml_reader.hpp"
#include "settings/settings_table.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <functional>

namespace drape::scene {
namespace {

constexpr double manyDegrees = 1e6;
constexpr std::size_t maxCloths = 64;

BandDescription readBand(const TomlReader& reader) {
  constexpr std::size_t maxPoints = 3;
  reader.allowOnly({"nearest", "vertices", "length"});
  const std::optional<Vec3> nearest = reader.vector("nearest");
  const std::vector<int> vertices = reader.integers("vertices");
  const std::optional<double> length = reader.number("length", minBandLength, maxBandLength);
  if (nearest.has_value() != vertices.empty() || vertices.size() > maxPoints || !length) {
    reader.fail(
        "a band needs nearest, a point at its border, or vertices, one of the border or the two ends of a part of it; "
        "and length, its rest length over that of the border");
  }
  return {nearest.value_or(Vec3::Zero()), *length, reader.place(), vertices};
}

/// The file with the start of a cloth.
std::optional<MeshFileSource> readStart(const TomlReader& reader, const std::filesystem::path& folder) {
  const std::optional<std::string> name = reader.text("start");
  if (!name) {
    return std::nullopt;
  }
  if (!io::isMeshFile(*name)) {
    reader.failAt("start", "start must name a mesh file with the vertices of the mesh: start = \"fitted.obj\"");
  }
  if (reader.has("pleats")) {
    reader.failAt("start", "a cloth has either pleats or a start");
  }
  return MeshFileSource{(folder / *name).string(), false, reader.place("start")};
}

/// Mesh, position, bands and pleats of a cloth. @param table "[cloth]" or "[[cloths]]", for messages
ClothDescription readCloth(const TomlReader& reader, const std::string& table, const std::filesystem::path& folder) {
  ClothDescription cloth;
  const bool mesh = reader.has("mesh");
  const auto plane = reader.text("grid");
  if (mesh && plane.has_value()) {
    reader.failAt("mesh", table + " has both mesh and grid; leave one of them out");
  }
  if (!mesh && !plane.has_value()) {
    reader.fail(table + " needs either mesh = \"file.obj\" or grid = \"horizontal\" or \"vertical\"");
  }
  if (mesh) {
    cloth.source = meshSource(reader, folder);
  } else if (*plane == "horizontal" || *plane == "vertical") {
    cloth.source = GridSource{*plane == "vertical" ? GridSource::Plane::Vertical : GridSource::Plane::Horizontal};
  } else {
    reader.failAt("grid", "cloth.grid must be \"horizontal\" or \"vertical\", not \"" + *plane + "\"");
  }
  cloth.start = readStart(reader, folder);
  cloth.position = reader.vector("position").value_or(Vec3::Zero());
  cloth.rotation = degree * reader.vector("rotation", manyDegrees).value_or(Vec3::Zero());
  cloth.placement = readPlacement(reader);
  cloth.writtenPlacement = cloth.placement;
  cloth.frozen = reader.flag("frozen").value_or(false);
  for (const TomlReader& band : reader.tables("bands")) {
    cloth.bands.push_back(readBand(band));
  }
  if (const auto pleats = reader.table("pleats")) {
    if (mesh) {
      reader.failAt("pleats", "pleats belong to a grid; for a mesh use start, a file with the pleated cloth");
    }
    pleats->allowOnly({"count", "gather"});
    cloth.pleats = Pleats{pleats->integer("count", 1, 1000).value_or(Pleats{}.count),
                          pleats->number("gather", 0.1, 1.0).value_or(Pleats{}.gather)};
  }
  return cloth;
}

PinSelection readPins(const TomlReader& reader) {
  reader.allowOnly({"vertices", "nearest", "boxes", "top", "corners", "edges", "every", "body", "keyframes", "loop"});
  PinSelection pins;
  pins.where = reader.place();
  pins.vertices = reader.integers("vertices");
  pins.whereVertices = reader.place("vertices");
  pins.nearest = reader.vectors("nearest");
  for (const TomlReader& box : reader.tables("boxes")) {
    box.allowOnly({"min", "max"});
    pins.boxes.push_back(
        {box.vector("min").value_or(Vec3::Constant(-farAway)), box.vector("max").value_or(Vec3::Constant(farAway))});
    if ((pins.boxes.back().min.array() > pins.boxes.back().max.array()).any()) {
      box.fail("a box needs min and max with no coordinate of min larger than that of max");
    }
  }
  pins.top = reader.number("top", 0.0, 1.0);
  pins.corners = reader.texts("corners");
  pins.edges = reader.texts("edges");
  pins.every = reader.integer("every", 1, 1000).value_or(1);
  if (reader.has("every") && pins.edges.empty()) {
    reader.failAt("every", "pins.every belongs to pins.edges");
  }
  pins.body = reader.text("body").value_or("");
  if (reader.has("keyframes")) {
    if (!pins.body.empty()) {
      reader.fail("pins follow either a body or keyframes, not both");
    }
    readKeyframes(reader, {}, pins.motion.emplace());
  } else if (reader.has("loop")) {
    reader.fail("loop needs keyframes");
  }
  return pins;
}

void readAllPins(const TomlReader& reader, std::vector<PinSelection>& pins) {
  for (const TomlReader& table : reader.tableOrTables("pins")) {
    pins.push_back(readPins(table));
  }
}

std::string nameOfCloth(const TomlReader& reader, const std::vector<ClothDescription>& others) {
  std::string name = reader.text("name").value_or("");
  if (name.empty()) {
    reader.fail("every table of [[cloths]] needs a name");
  }
  if (std::ranges::any_of(others, [&](const ClothDescription& other) { return other.name == name; })) {
    reader.fail("there are two cloths with the name \"" + name + "\"");
  }
  return name;
}

/// The cloths of a scene: the table [cloth] with its pins, or the tables [[cloths]]. Their own settings are not read.
std::vector<ClothDescription> readCloths(const TomlReader& reader, const std::string& file,
                                         const std::filesystem::path& folder) {
  const auto only = reader.table("cloth");
  const std::vector<TomlReader> several = reader.tables("cloths");
  if (only.has_value() && !several.empty()) {
    reader.failAt("cloths", "a scene has either a table [cloth] or tables [[cloths]], not both");
  }
  if (!only.has_value() && several.empty()) {
    throw messages::InputError(file +
                               ": a scene needs either a table [cloth] or tables [[cloths]], with a mesh or a "
                               "grid");
  }
  std::vector<ClothDescription> cloths;
  if (only) {
    only->allowOnly({"mesh", "grid", "start", "position", "rotation", "placement", "frozen", "pleats", "bands"});
    cloths.push_back(readCloth(*only, "[cloth]", folder));
    readAllPins(reader, cloths.front().pins);
    return cloths;
  }
  if (reader.has("pins")) {
    throw messages::InputError(reader.place("pins") + ": with [[cloths]] each cloth has its own pins: [[cloths.pins]]");
  }
  if (several.size() > maxCloths) {
    several[maxCloths].fail(fmt::format("a scene can have at most {} cloths", maxCloths));
  }
  for (const TomlReader& table : several) {
    table.allowOnly({"name", "mesh", "grid", "start", "position", "rotation", "placement", "frozen", "pleats", "bands",
                     "pins", "settings"});
    const std::string name = nameOfCloth(table, cloths);
    ClothDescription& cloth = cloths.emplace_back(readCloth(table, "[[cloths]]", folder));
    cloth.name = name;
    readAllPins(table, cloth.pins);
  }
  return cloths;
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
  reader.allowOnly({"position", "focal_point", "view_angle", "orthographic"});
  CameraPose pose;
  pose.position = reader.vector("position").value_or(pose.position);
  pose.focalPoint = reader.vector("focal_point").value_or(pose.focalPoint);
  pose.viewAngle = reader.number("view_angle", 1.0, 150.0).value_or(pose.viewAngle);
  pose.isOrthographic = reader.flag("orthographic").value_or(pose.isOrthographic);
  if (!isFarEnough(pose)) {
    reader.fail(fmt::format("camera.position and camera.focal_point must be at least {:.2f} m apart", minViewDistance));
  }
  return pose;
}

/// Checks that the bodies of the pins exist.
void requireCarriers(const SceneDescription& description) {
  const auto& bodies = description.bodies;
  for (const ClothDescription& cloth : description.cloths) {
    for (const PinSelection& pins : cloth.pins) {
      const auto isCarrier = [&](const BodyDescription& each) { return each.body.name == pins.body; };
      if (!pins.body.empty() && std::none_of(bodies.begin(), bodies.end(), isCarrier)) {
        throw messages::InputError(pins.where + ": pins.body: there is no body with the name \"" + pins.body + "\"");
      }
    }
  }
}

/// Throws at the first of these keys that the table has, or at its start.
[[noreturn]] void failAtFirst(const TomlReader& reader, const std::vector<std::string_view>& keys,
                              const std::string& message) {
  for (const std::string_view wanted : keys) {
    reader.forEachValue([&](const std::string& key, const toml::node& node) {
      if (key == wanted) {
        reader.fail(node, message);
      }
    });
  }
  reader.fail(message);
}

/// Assigns the settings of a table, and adds notes about former keys to those of the scene.
/// @param onAssigned called with each setting and its value
void readSettings(const TomlReader& reader, settings::Settings& settings, std::vector<std::string>& notes,
                  const std::function<void(const settings::SettingInfo&)>& onAssigned = {}) {
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
      if (onAssigned) {
        onAssigned(info);
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
        notes.push_back(reader.placeOf(node) + ": " + note);
      }
      assign(key, node, depth);
    });
  }
  try {
    settings::requireConsistent(settings);
  } catch (const settings::ConflictError& error) {
    failAtFirst(reader, error.keys(), error.what());
  }
}

/// The format of a file. Refuses a file of a newer version as such, before its unknown keys are errors.
int knownFormat(const TomlReader& reader) {
  constexpr int manyFormats = 1'000'000;
  const int format = reader.integer("format", 1, manyFormats).value_or(sceneFormat);
  if (format > sceneFormat) {
    throw messages::InputError(fmt::format(
        "{}: a newer version of Drape wrote this scene (format {}); this version reads formats up to {}. Update Drape.",
        reader.place("format"), format, sceneFormat));
  }
  return format;
}

/// The settings of a file that sets none.
settings::Settings defaultsOfFormat(int format) {
  settings::Settings settings;
  if (format == 1) {
    settings.step.contact.self = sim::contact::SelfCollision::Off;
  }
  return settings;
}

/// Reads the settings that a cloth has for itself.
void readOwnSettings(const TomlReader& reader, SceneDescription& scene, ClothDescription& cloth) {
  settings::Settings changed = scene.settings;
  readSettings(reader, changed, scene.notes, [&](const settings::SettingInfo& info) {
    if (!mayDifferByCloth(info)) {
      throw messages::UsageError(std::string(info.key) +
                                 " is the same for all cloths of a scene; set it under [settings]");
    }
    cloth.own.push_back({&info, settings::settingValue(changed, info)});
  });
}

}  // namespace

SceneDescription parseScene(std::string_view text, const std::string& name, const std::string& file,
                            const std::filesystem::path& folder, const settings::OwnFabrics& own) {
  const TomlReader reader(text, file);
  const int format = knownFormat(reader);
  reader.allowOnly({"format", "title", "help", "cloth", "cloths", "pins", "seams", "camera", "stand", "ground",
                    "bodies", "settings", "fabrics"});
  SceneDescription scene;
  scene.settings = defaultsOfFormat(format);
  scene.settings.fabric.own = settings::joined(own, readFabrics(reader));
  scene.name = name;
  scene.title = reader.text("title").value_or(name);
  scene.help = reader.text("help").value_or("");
  scene.cloths = readCloths(reader, file, folder);
  for (const TomlReader& seam : reader.tables("seams")) {
    scene.seams.push_back(readSeam(seam));
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
  requireCarriers(scene);
  if (const auto settings = reader.table("settings")) {
    readSettings(*settings, scene.settings, scene.notes);
  }
  const std::vector<TomlReader> cloths = reader.tables("cloths");
  for (std::size_t i = 0; i < cloths.size(); ++i) {
    if (const auto settings = cloths[i].table("settings")) {
      readOwnSettings(*settings, scene, scene.cloths[i]);
    }
  }
  return scene;
}

}  // namespace drape::scene
