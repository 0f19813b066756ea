#include "embed/embedded_file.hpp"
#include "messages/error.hpp"
#include "scene/builtin_meshes.hpp"
#include "scene/opened_mesh.hpp"
#include "scene/scene.hpp"
#include "scene/scene_file.hpp"
#include "scene/text_file.hpp"

#include <algorithm>
#include <span>

namespace drape::scene {

std::span<const EmbeddedFile> embeddedScenes();
std::span<const EmbeddedFile> embeddedMeshes();

namespace {

constexpr std::string_view sceneEnding = ".toml";

std::string sceneName(const EmbeddedFile& file) {
  return std::string(file.name.substr(0, file.name.size() - sceneEnding.size()));
}

std::string listOf(std::span<const EmbeddedFile> files) {
  std::string names;
  for (const EmbeddedFile& file : files) {
    names += (names.empty() ? "" : ", ") + std::string(file.name);
  }
  return names;
}

std::string sceneNames() {
  std::string names;
  for (const SceneInfo& info : sceneList()) {
    names += (names.empty() ? "" : ", ") + info.name;
  }
  return names;
}

SceneDescription sceneOfMesh(const std::filesystem::path& file, const settings::OwnFabrics& own) {
  SceneDescription scene;
  scene.name = file.filename().string();
  scene.title = scene.name;
  scene.help = "A mesh file without a scene.";
  scene.cloth().source = MeshFileSource{file.string(), false};
  scene.cloth().pins.emplace_back().top = topOfBareMesh;
  scene.groundBelowCloth = true;
  scene.settings = openedMeshSettings();
  scene.settings.fabric.own = own;
  scene.opened = true;
  scene.settings.mesh.unit = "auto";
  scene.settings.mesh.up = "auto";
  scene.settings.mesh.pins = "shape";
  return scene;
}

SceneDescription openFile(const std::filesystem::path& file, const settings::OwnFabrics& own) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw messages::InputError(file.string() + " is a folder; give a scene (.toml) or a mesh file");
  }
  if (!std::filesystem::exists(file, error)) {
    if (file.has_parent_path() || file.has_extension()) {
      throw messages::InputError("there is no file '" + file.string() + "'");
    }
    throw messages::InputError("there is no scene and no file '" + file.string() + "'; the built-in scenes are " +
                               sceneNames());
  }
  if (file.extension() == sceneEnding) {
    return parseScene(readTextFile(file), file.stem().string(), file.string(), file.parent_path(), own);
  }
  if (io::isMeshFile(file)) {
    return sceneOfMesh(file, own);
  }
  if (const std::string advice = io::adviceForFormat(file); !advice.empty()) {
    throw messages::InputError(file.string() + ": " + advice);
  }
  std::string formats;
  for (const std::string& format : io::meshFormats()) {
    formats += ", ." + format;
  }
  throw messages::InputError(file.string() + " is neither a scene nor a known mesh format; known extensions: .toml" +
                             formats);
}

}  // namespace

std::string_view builtinMesh(std::string_view name) {
  const auto meshes = embeddedMeshes();
  const auto found =
      std::find_if(meshes.begin(), meshes.end(), [&](const EmbeddedFile& file) { return file.name == name; });
  if (found == meshes.end()) {
    throw messages::InputError("there is no built-in mesh '" + std::string(name) + "'; the built-in meshes are " +
                               listOf(meshes));
  }
  return found->bytes;
}

std::vector<SceneInfo> sceneList() {
  std::vector<SceneInfo> list;
  for (const EmbeddedFile& file : embeddedScenes()) {
    const SceneDescription scene = parseScene(file.bytes, sceneName(file), std::string(file.name), {});
    list.push_back({scene.name, scene.title, scene.help});
  }
  return list;
}

SceneDescription openScene(const std::string& nameOrPath, const settings::OwnFabrics& own) {
  for (const EmbeddedFile& file : embeddedScenes()) {
    if (sceneName(file) == nameOrPath) {
      SceneDescription scene = parseScene(file.bytes, nameOrPath, std::string(file.name), {}, own);
      scene.parts.scene = nameOrPath;
      return scene;
    }
  }
  SceneDescription scene = openFile(nameOrPath, own);
  scene.parts.scene = nameOrPath;
  return scene;
}

}  // namespace drape::scene
