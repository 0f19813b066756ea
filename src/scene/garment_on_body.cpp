#include "scene/garment_on_body.hpp"

#include "io/animation_import.hpp"
#include "messages/error.hpp"
#include "scene/found_mesh.hpp"
#include "scene/mesh_file.hpp"
#include "scene/opened_mesh.hpp"
#include "scene/unit_guess.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace drape::scene {
namespace {

constexpr std::string_view figureName = "figure";
constexpr std::array<std::string_view, 2> builtinBodies{"mannequin", figureName};

constexpr std::string_view builtinPrefix = "builtin:";

/// The unit and the up axis of the body, as the user chooses them or from its file.
ReadingChoice readingOfBody(const settings::Settings& settings, const MeshFileSource& file,
                            const ReadingChoice& choice) {
  io::ImportOptions options;
  options.use = io::MeshUse::Body;
  options.maxTriangles = io::maxMovingTriangles;
  options.outliers = outlierRule(settings);
  const MeshReading reading = readingOf(foundIn(readMesh(file, options)), choice, io::MeshUse::Body);
  return {reading.unit, reading.up};
}

/// A scene of the garment alone.
SceneDescription openGarment(const std::string& garment, const settings::OwnFabrics& own) {
  if (!garment.starts_with(builtinPrefix)) {
    SceneDescription scene = openScene(garment, own);
    if (!scene.opened) {
      throw messages::InputError(garment + " is a scene; the garment must be a mesh file");
    }
    return scene;
  }
  SceneDescription scene;
  scene.name = garment.substr(builtinPrefix.size());
  scene.title = scene.name;
  scene.cloth().source = MeshFileSource{scene.name, true};
  scene.settings = openedMeshSettings();
  scene.settings.fabric.own = own;
  scene.settings.mesh.unit = "m";
  scene.settings.mesh.up = "y";
  scene.opened = true;
  return scene;
}

/// Whether a choice leaves a mesh in metres with y up as it is.
bool isInMetres(const ReadingChoice& choice) {
  const ReadingChoice open;
  return (choice.unit == open.unit || choice.unit == "m") && (choice.up == open.up || choice.up == "y");
}

bool isBuiltInBody(const std::string& body) {
  return std::ranges::find(builtinBodies, body) != builtinBodies.end();
}

}  // namespace

bool isBuiltInWear(const std::string& name) {
  return name.starts_with(builtinPrefix) || isBuiltInBody(name);
}

MeshFileSource wearSource(const std::string& name) {
  if (name.starts_with(builtinPrefix)) {
    return {name.substr(builtinPrefix.size()), true};
  }
  const bool isBuiltIn = isBuiltInBody(name);
  return {isBuiltIn ? name + ".obj" : name, isBuiltIn};
}

BodyDescription bodyOfFile(const std::string& body, const settings::Settings& settings, const ReadingChoice& choice) {
  BodyDescription description;
  description.body.name = std::filesystem::path(body).stem().string();
  description.body.motion.keyframes = {sim::contact::Keyframe{}};
  const bool isBuiltIn = isBuiltInBody(body);
  if (!isBuiltIn && !io::isMeshFile(body)) {
    throw messages::InputError("the body '" + body + "' is no mesh file; give one, or mannequin or figure" +
                               (io::isAnimationFile(body) ? ", or the name of a clip in it (--clip)" : ""));
  }
  if (isBuiltIn && !isInMetres(choice)) {
    throw messages::InputError("the body " + body +
                               " is built in: it is in metres with y up, and cannot be read in "
                               "another way");
  }
  description.meshes = {wearSource(body)};
  if (body == figureName) {
    description.figure.emplace();  // in its rest pose, until the user chooses a motion
  }
  if (!isBuiltIn) {
    description.reading = readingOfBody(settings, description.meshes.front(), choice);
    description.openedReading = description.reading;
  }
  return description;
}

BodyDescription animatedBodyOfFile(const std::string& body, const std::string& clip, const ReadingChoice& choice) {
  if (isBuiltInBody(body) || !io::isAnimationFile(body)) {
    throw messages::InputError(
        "the body '" + body +
        "' has no clips; give a file in the format .glb, .gltf, .fbx or .dae, or leave --clip out");
  }
  const bool isGltf = io::isMeshFile(body);  // the only format for both meshes and animations
  if (choice.up != ReadingChoice().up || (choice.unit != ReadingChoice().unit && !isGltf)) {
    throw messages::InputError(body + " states its unit and its up axis; leave --body-unit and --body-up out");
  }
  BodyDescription description;
  description.body.name = std::filesystem::path(body).stem().string();
  description.body.motion.keyframes = {sim::contact::Keyframe{}};
  description.meshes = {MeshFileSource{body}};
  description.animation = AnimationSource{clip, AnimationSource{}.rate, figure::blendTime};
  description.frameLoop = true;
  description.scale = choice.unit == ReadingChoice().unit ? 1.0 : metresPerUnit(choice.unit);
  return description;
}

SceneDescription openGarmentOnBody(const std::string& garment, const std::string& body, const settings::OwnFabrics& own,
                                   const ReadingChoice& bodyReading, const std::optional<std::string>& clip) {
  SceneDescription scene = openGarment(garment, own);
  scene.bodies = {clip ? animatedBodyOfFile(body, *clip, bodyReading) : bodyOfFile(body, scene.settings, bodyReading)};
  scene.settings.mesh.pins = "none";
  scene.groundBelowCloth = false;
  scene.ground.reset();
  scene.parts = {.cloth = garment, .bodies = {body}, .dressed = true};
  scene.parts.bodyReadings = {bodyReading};
  scene.parts.bodyClips = {clip};
  return scene;
}

}  // namespace drape::scene
