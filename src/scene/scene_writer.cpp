#include "scene/scene_writer.hpp"

#include "messages/error.hpp"
#include "scene/body_builder.hpp"
#include "scene/body_writer.hpp"
#include "scene/fabric_file.hpp"
#include "scene/keyframe_file.hpp"
#include "scene/mesh_reading.hpp"
#include "scene/placement_file.hpp"
#include "scene/scene_file.hpp"
#include "scene/seam_file.hpp"
#include "scene/settings_writer.hpp"
#include "scene/unit_guess.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>
#include <variant>

namespace drape::scene {
namespace {

/// The parts that all functions below need.
struct Writing {
  const Scene& scene;
  const SceneNow& now;
  const std::filesystem::path& folder;
  WrittenScene& result;
  TomlText toml = {};
  Sewing ofScene = sewingOf(scene.description);

  [[nodiscard]] const Sewing& sewing() const { return now.sewing ? *now.sewing : ofScene; }
  [[nodiscard]] const SceneDescription& description() const { return scene.description; }
  [[nodiscard]] bool hasOwnPins() const { return now.pinned != scene.model->pinned || now.pinPaths != scene.pinPaths; }
  [[nodiscard]] bool hasSeveral() const {
    return description().cloths.size() > 1 || !description().cloth().name.empty();
  }
};

std::string listOf(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) {
    list += (list.empty() ? "" : ", ") + quotedText(text);
  }
  return "[" + list + "]";
}

void writePins(const PinSelection& pins, const std::string& header, TomlText& toml) {
  toml.table(header, true);
  if (!pins.vertices.empty()) {
    toml.value("vertices", listText(pins.vertices));
  }
  if (!pins.nearest.empty()) {
    std::string points;
    for (const Vec3& point : pins.nearest) {
      points += (points.empty() ? "" : ", ") + vectorText(point);
    }
    toml.value("nearest", "[" + points + "]");
  }
  if (!pins.boxes.empty()) {
    std::string boxes;
    for (const PinSelection::Box& box : pins.boxes) {
      boxes += fmt::format("{}{{ min = {}, max = {} }}", boxes.empty() ? "" : ", ", vectorText(box.min),
                           vectorText(box.max));
    }
    toml.value("boxes", "[" + boxes + "]");
  }
  if (pins.top) {
    toml.number("top", *pins.top);
  }
  if (!pins.corners.empty()) {
    toml.value("corners", listOf(pins.corners));
  }
  if (!pins.edges.empty()) {
    toml.value("edges", listOf(pins.edges));
  }
  if (pins.every != 1) {
    toml.value("every", std::to_string(pins.every));
  }
  if (!pins.body.empty()) {
    toml.text("body", pins.body);
  }
  if (pins.motion) {
    writeKeyframes(*pins.motion, toml);
  }
}

/// Takes those of `vertices` that are left, counted from the first one of the cloth.
std::vector<int> taken(const std::vector<int>& vertices, const ClothPart& cloth, std::vector<int>& left) {
  std::vector<int> found;
  for (const int vertex : vertices) {
    if (std::erase(left, vertex - cloth.firstVertex) > 0) {
      found.push_back(vertex - cloth.firstVertex);
    }
  }
  return found;
}

/// The pins that the user has now, by vertex: a group for each body that carries some, one for each path, and one for
/// the others.
std::vector<PinSelection> pinsNow(const Writing& writing, const ClothPart& cloth) {
  std::vector<int> left;
  for (int v = 0; v < cloth.vertexCount; ++v) {
    if (writing.now.pinned[cloth.firstVertex + v]) {
      left.push_back(v);
    }
  }
  std::vector<PinSelection> groups;
  const auto addGroup = [&](const std::vector<int>& vertices, const std::string& body,
                            const std::optional<sim::contact::BodyMotion>& motion) {
    PinSelection group;
    group.vertices = taken(vertices, cloth, left);
    group.body = body;
    group.motion = motion;
    if (!group.vertices.empty()) {
      groups.push_back(std::move(group));
    }
  };
  for (std::size_t i = 0; i < writing.description().bodies.size(); ++i) {
    const sim::contact::Body& body = (*writing.scene.bodies)[i];
    std::vector<int> carried;
    std::ranges::transform(body.pins, std::back_inserter(carried), &sim::contact::CarriedPin::vertex);
    addGroup(carried, body.name, std::nullopt);
  }
  for (const PinPath& path : writing.now.pinPaths) {
    addGroup(path.vertices, "", path.motion);
  }
  if (!left.empty()) {
    groups.emplace_back().vertices = std::move(left);
  }
  return groups;
}

void writeBands(const std::vector<BandDescription>& bands, TomlText& toml) {
  std::string list;
  for (const BandDescription& band : bands) {
    const std::string border =
        band.vertices.empty() ? "nearest = " + vectorText(band.nearest) : "vertices = " + listText(band.vertices);
    list +=
        fmt::format("{}{{ {}, length = {} }}", list.empty() ? "" : ", ", border, settings::formatValue(band.length));
  }
  if (!list.empty()) {
    toml.value("bands", "[" + list + "]");
  }
}

void writeCloth(Writing& writing, std::size_t index) {
  const ClothDescription& cloth = writing.description().cloths[index];
  TomlText& toml = writing.toml;
  toml.table(writing.hasSeveral() ? "[[cloths]]" : "[cloth]", true);
  if (writing.hasSeveral()) {
    toml.text("name", cloth.name);
  }
  if (const auto* grid = std::get_if<GridSource>(&cloth.source)) {
    toml.text("grid", grid->plane == GridSource::Plane::Vertical ? "vertical" : "horizontal");
  } else {
    toml.text("mesh", meshName(std::get<MeshFileSource>(cloth.source), writing.folder));
  }
  const auto& start = writing.now.starts.empty() ? cloth.start : writing.now.starts.at(index);
  if (start) {
    toml.text("start", meshName(*start, writing.folder));
  }
  if (!cloth.position.isZero(0.0)) {
    toml.value("position", vectorText(cloth.position));
  }
  if (!cloth.rotation.isZero(0.0)) {
    toml.value("rotation", degreesText(cloth.rotation));
  }
  writePlacement(cloth.placement, toml);
  if (cloth.frozen) {
    toml.value("frozen", "true");
  }
  if (cloth.pleats) {
    toml.value("pleats", fmt::format("{{ count = {}, gather = {} }}", cloth.pleats->count,
                                     settings::formatValue(cloth.pleats->gather)));
  }
  writeBands(writing.sewing().bands.at(index), toml);
}

bool isFromFileOfUser(const ClothDescription& cloth) {
  const auto* mesh = std::get_if<MeshFileSource>(&cloth.source);
  return mesh != nullptr && !mesh->builtIn;
}

/// The settings `unit` and `up` of a cloth, with those that were guessed instead of "auto": so the scene is read in the
/// same way again, and asks nothing.
ReadingChoice statedReading(const Writing& writing, std::size_t index) {
  constexpr std::string_view guessed = "auto";
  const ClothPart& part = writing.scene.cloths[index];
  const settings::Settings::Mesh mesh = settingsOf(part.own, writing.now.settings).mesh;
  if (!isFromFileOfUser(writing.description().cloths[index])) {
    return {mesh.unit, mesh.up};
  }
  return {mesh.unit == guessed ? wordForUnit(part.placement.metresPerUnit) : mesh.unit,
          mesh.up == guessed ? part.placement.up : mesh.up};
}

/// What a cloth has for itself. Of several cloths each is read in its own unit.
std::vector<OwnSetting> ownSettingsNow(const Writing& writing, std::size_t index) {
  std::vector<OwnSetting> own = writing.description().cloths[index].own;
  for (OwnSetting& each : own) {
    if (writing.hasOwnPins() && each.info->key == "pins") {
      each.value = std::string("scene");
    }
  }
  const ReadingChoice reading = statedReading(writing, index);
  const settings::Settings present = settingsOf(own, writing.now.settings);
  const auto state = [&](std::string_view key, const std::string& before, const std::string& stated) {
    if (stated != before) {
      std::erase_if(own, [&](const OwnSetting& each) { return each.info->key == key; });
      own.push_back({&settings::requireSetting(key), stated});
    }
  };
  if (writing.hasSeveral()) {
    state("unit", present.mesh.unit, reading.unit);
    state("up", present.mesh.up, reading.up);
  }
  return own;
}

void writeClothSettings(Writing& writing, std::size_t index) {
  writing.toml.table("[cloths.settings]");
  for (const OwnSetting& own : ownSettingsNow(writing, index)) {
    writing.toml.value(own.info->key, valueText(own.value));
  }
}

void writeCloths(Writing& writing) {
  for (std::size_t i = 0; i < writing.description().cloths.size(); ++i) {
    const ClothDescription& cloth = writing.description().cloths[i];
    writeCloth(writing, i);
    writeClothSettings(writing, i);
    const std::vector<PinSelection> pins =
        writing.hasOwnPins() ? pinsNow(writing, writing.scene.cloths[i]) : cloth.pins;
    const std::string name = writing.hasSeveral() ? "cloths.pins" : "pins";
    for (const PinSelection& each : pins) {
      writePins(each, pins.size() == 1 && !writing.hasSeveral() ? "[" + name + "]" : "[[" + name + "]]", writing.toml);
    }
  }
}

void writeCamera(const std::optional<CameraPose>& camera, TomlText& toml) {
  if (camera) {
    toml.table("[camera]");
    toml.value("position", vectorText(camera->position));
    toml.value("focal_point", vectorText(camera->focalPoint));
    toml.number("view_angle", camera->viewAngle);
    if (camera->isOrthographic) {
      toml.flag("orthographic", true);
    }
  }
}

/// The surface and the contact of a stand or the ground, or "solid = false" when it is or was switched off.
void writeSolidity(const std::optional<sim::contact::Body>& body, const BodyNow* now, TomlText& toml) {
  if (!body || (now != nullptr && !now->on)) {
    toml.flag("solid", false);
  } else {
    writeSurface(now == nullptr ? body->surface : now->surface, toml);
  }
}

/// The unit and the up axis of the first cloth from a file, for the bodies that are read like it.
BodyDescription bodyInMetres(BodyDescription body, const Scene& scene) {
  const auto isFromFile = [&](const ClothPart& part) {
    return isFromFileOfUser(scene.description.cloths[static_cast<std::size_t>(&part - scene.cloths.data())]);
  };
  const auto found = std::ranges::find_if(scene.cloths, isFromFile);
  const MeshPlacement& placement = (found == scene.cloths.end() ? scene.cloths.front() : *found).placement;
  return inMetres(std::move(body), placement.metresPerUnit, placement.up);
}

/// Moves a body after its own motion and its placement.
void shift(const Vec3& by, BodyDescription& body) {
  if (!body.placement.isNone()) {
    body.placement.position += by;
    return;
  }
  for (sim::contact::Keyframe& key : body.body.motion.keyframes) {
    key.position += by;
  }
}

void writeBodies(Writing& writing) {
  const auto& descriptions = writing.description().bodies;
  for (std::size_t i = 0; i < descriptions.size(); ++i) {
    BodyDescription body = bodyInMetres(descriptions[i], writing.scene);
    if (i < writing.now.bodies.size()) {
      const BodyNow& now = writing.now.bodies[i];
      body.body.surface = now.surface;
      body.figure = now.figure && body.figure ? now.figure : body.figure;
      shift(now.shift, body);
      if (!now.on) {
        writing.result.notes.emplace_back("A scene file cannot say that {} is switched off", body.body.name);
      }
    }
    writeBody(body, writing.folder, writing.toml);
  }
}

void writeStandAndGround(Writing& writing) {
  const SceneDescription& description = writing.description();
  std::size_t next = description.bodies.size();  // in the list of bodies: first the stand, then the ground
  const auto nowOf = [&](const std::optional<sim::contact::Body>& body) -> const BodyNow* {
    return body && next < writing.now.bodies.size() ? &writing.now.bodies[next++] : nullptr;
  };
  if (description.stand) {
    writing.toml.table("[stand]");
    writing.toml.text("mesh", meshName(description.stand->mesh, writing.folder));
    writeSolidity(description.stand->body, nowOf(description.stand->body), writing.toml);
  }
  writing.toml.table("[ground]");
  if (description.groundHeight || description.groundBelowCloth) {
    writing.toml.number("height", description.groundHeight.value_or(writing.scene.groundHeight));
  }
  writeSolidity(description.ground, nowOf(description.ground), writing.toml);
}

/// Everything but the settings.
std::string documentText(Writing& writing) {
  const SceneDescription& description = writing.description();
  writing.toml.value("format", std::to_string(sceneFormat));
  writing.toml.text("title", description.title);
  if (!description.help.empty() && !description.opened) {
    writing.toml.text("help", description.help);
  }
  writeCloths(writing);
  for (const SeamDescription& seam : writing.sewing().seams) {
    writeSeam(seam, writing.toml);
  }
  writeCamera(writing.now.camera ? writing.now.camera : description.camera, writing.toml);
  writeBodies(writing);
  writeStandAndGround(writing);
  for (const settings::OwnFabric& fabric : usedFabrics(writing.now.settings, writing.scene.cloths)) {
    writing.toml.append(fabricEntry(fabric));
  }
  return writing.toml.document();
}

}  // namespace

SceneNow unchanged(const Scene& scene) {
  return {scene.settings, scene.model->pinned, scene.pinPaths, {}};
}

WrittenScene writeScene(const Scene& scene, const SceneNow& now, const std::filesystem::path& folder) {
  WrittenScene result;
  Writing writing{scene, now, folder, result};
  const std::string document = documentText(writing);
  settings::Settings target = now.settings;
  if (writing.hasOwnPins()) {
    target.mesh.pins = "scene";
    result.notes.emplace_back("Pins are where the cloth starts, not where you set them");
  }
  if (!writing.hasSeveral()) {
    const ReadingChoice reading = statedReading(writing, 0);
    target.mesh.unit = reading.unit;
    target.mesh.up = reading.up;
  }
  const auto textWith = [&](const std::vector<const settings::SettingInfo*>& written) {
    return document + '\n' + settingsText(target, written);
  };
  const auto written = settingsToWrite(target, [&](const std::vector<const settings::SettingInfo*>& some) {
    return parseScene(textWith(some), scene.description.name, "the scene file", folder).settings;
  });
  result.text = textWith(written);
  return result;
}

}  // namespace drape::scene
