#include "scene/scene_parts.hpp"

#include "messages/error.hpp"
#include "scene/garment_on_body.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace drape::scene {
namespace {

constexpr std::size_t maxBodies = 32;

std::string freeName(const std::vector<BodyDescription>& bodies, const std::string& wanted) {
  const auto taken = [&](const std::string& name) {
    return std::any_of(bodies.begin(), bodies.end(),
                       [&](const BodyDescription& other) { return other.body.name == name; });
  };
  std::string name = wanted;
  for (int number = 2; taken(name); ++number) {
    name = wanted + " " + std::to_string(number);
  }
  return name;
}

void replaceCloth(SceneDescription& scene, const std::string& file) {
  SceneDescription cloth = openScene(file);
  if (!std::holds_alternative<MeshFileSource>(cloth.cloth().source)) {
    throw messages::InputError(file + " is not a mesh; the cloth for a scene must be a mesh");
  }
  scene.name = cloth.name;
  scene.title = cloth.title;
  scene.cloths = std::move(cloth.cloths);
  scene.settings.mesh = cloth.settings.mesh;
  scene.stand.reset();
  scene.camera.reset();
}

/// Takes the unit and the up axis of the cloth's file from the choice of the user, unless that is "auto".
void readCloth(const ReadingChoice& choice, SceneDescription& scene) {
  const ReadingChoice open;
  settings::Settings::Mesh& mesh = scene.settings.mesh;
  mesh.unit = choice.unit == open.unit ? mesh.unit : choice.unit;
  mesh.up = choice.up == open.up ? mesh.up : choice.up;
}

/// The choice for the i-th body.
ReadingChoice bodyReading(const SceneParts& parts, std::size_t i) {
  return i < parts.bodyReadings.size() ? parts.bodyReadings[i] : ReadingChoice();
}

/// The clip of the i-th body.
std::optional<std::string> bodyClip(const SceneParts& parts, std::size_t i) {
  return i < parts.bodyClips.size() ? parts.bodyClips[i] : std::nullopt;
}

void addBody(SceneDescription& scene, const SceneParts& parts, std::size_t i) {
  const std::string& file = parts.bodies[i];
  const ReadingChoice reading = bodyReading(parts, i);
  if (const std::optional<std::string> clip = bodyClip(parts, i)) {
    BodyDescription body = animatedBodyOfFile(file, *clip, reading);
    body.body.name = freeName(scene.bodies, body.body.name);
    scene.bodies.push_back(std::move(body));
    return;
  }
  if (parts.dressed || isBuiltInWear(file) || reading != ReadingChoice()) {
    BodyDescription body = bodyOfFile(file, scene.settings, reading);
    body.body.name = freeName(scene.bodies, body.body.name);
    scene.bodies.push_back(std::move(body));
    return;
  }
  if (!io::isMeshFile(file)) {
    throw messages::InputError(file + " is not a mesh; only a mesh can be a body");
  }
  BodyDescription description;
  description.body.name = freeName(scene.bodies, std::filesystem::path(file).stem().string());
  description.body.motion.keyframes = {sim::contact::Keyframe{}};
  description.meshes = {MeshFileSource{file, false}};
  description.readLikeCloth = true;
  scene.bodies.push_back(std::move(description));
}

std::string stemOf(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

/// Gives each cache to the body with its name, or to the only body.
void attachCaches(SceneDescription& scene, const SceneParts& parts) {
  const std::size_t first = scene.bodies.size() - parts.bodies.size();
  for (const std::string& cache : parts.caches) {
    std::size_t found = 0;
    while (found < parts.bodies.size() && stemOf(parts.bodies[found]) != stemOf(cache)) {
      ++found;
    }
    if (found == parts.bodies.size() && parts.bodies.size() != 1) {
      throw messages::InputError(cache +
                                 ": no mesh of a body has this name, so the cache has nothing to move. Give both "
                                 "files the same name: body.obj and body.pc2");
    }
    BodyDescription& body = scene.bodies[first + (found == parts.bodies.size() ? 0 : found)];
    if (body.figure || body.meshes.front().builtIn) {
      throw messages::InputError(cache + ": a cache moves a mesh from a file, not a built-in body");
    }
    body.cache = CacheSource{cache};
  }
}

}  // namespace

SceneDescription openParts(const SceneParts& parts, const settings::OwnFabrics& own) {
  if (parts.bodies.size() > maxBodies) {
    throw messages::InputError("there are " + std::to_string(parts.bodies.size()) + " files for bodies; drop at most " +
                               std::to_string(maxBodies) + " at a time");
  }
  if (parts.dressed && parts.scene.empty() && parts.bodies.size() == 1) {
    SceneDescription scene =
        openGarmentOnBody(parts.cloth, parts.bodies.front(), own, bodyReading(parts, 0), bodyClip(parts, 0));
    readCloth(parts.clothReading, scene);
    attachCaches(scene, parts);
    scene.parts = parts;
    return scene;
  }
  SceneDescription scene = openScene(parts.scene.empty() ? parts.cloth : parts.scene, own);
  if (!parts.scene.empty() && !parts.cloth.empty()) {
    replaceCloth(scene, parts.cloth);
  }
  if (!parts.cloth.empty() || scene.opened) {
    readCloth(parts.clothReading, scene);
  }
  for (std::size_t i = 0; i < parts.bodies.size(); ++i) {
    addBody(scene, parts, i);
  }
  attachCaches(scene, parts);
  if (parts.dressed || (!parts.bodies.empty() && scene.opened)) {
    scene.settings.mesh.pins = "none";  // the cloth lies on the body
  }
  if (!parts.bodies.empty() && scene.groundBelowCloth) {
    // The bodies stand on the ground of their files, and the cloth fits to them there.
    scene.groundBelowCloth = false;
    scene.groundHeight = 0.0;
  }
  scene.parts = parts;
  return scene;
}

}  // namespace drape::scene
