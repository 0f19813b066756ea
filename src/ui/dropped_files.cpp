#include "ui/dropped_files.hpp"

#include "io/mesh_import.hpp"
#include "io/point_cache_import.hpp"
#include "text/words.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace drape::ui {
namespace {

bool hasBodyName(const std::string& file) {
  static constexpr std::array<std::string_view, 9> words{"body",   "avatar", "mannequin", "figure", "human",
                                                         "person", "woman",  "smpl",      "dummy"};
  const std::string name = text::lowerCase(shortName(file));
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

/// A body by its name, or since a vertex cache of its name moves it.
bool isBody(const DroppedFiles& files, const std::string& file) {
  const auto stem = [](const std::string& name) { return std::filesystem::path(name).stem(); };
  return hasBodyName(file) ||
         std::ranges::any_of(files.caches, [&](const std::string& cache) { return stem(cache) == stem(file); });
}

bool hasMeshBody(const scene::SceneDescription& scene) {
  return std::ranges::any_of(scene.bodies, [](const scene::BodyDescription& body) { return !body.meshes.empty(); });
}

std::string listOf(const std::vector<std::string>& files) {
  std::string names;
  for (const std::string& file : files) {
    names += (names.empty() ? "" : ", ") + shortName(file);
  }
  return names;
}

}  // namespace

std::string shortName(const std::string& file) {
  return std::filesystem::path(file).filename().string();
}

std::vector<std::string> distinctNames(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  for (const std::string& file : files) {
    const std::string name = shortName(file);
    const auto same =
        std::count_if(files.begin(), files.end(), [&](const std::string& other) { return shortName(other) == name; });
    const std::string folder = std::filesystem::path(file).parent_path().filename().string();
    names.push_back(same > 1 && !folder.empty() ? name + " (" + folder + ")" : name);
  }
  return names;
}

DroppedFiles sortDropped(const std::vector<std::string>& files) {
  DroppedFiles sorted;
  for (const std::string& file : files) {
    const bool scene = text::lowerCase(std::filesystem::path(file).extension().string()) == ".toml";
    (scene                    ? sorted.scenes
     : io::isMeshFile(file)   ? sorted.meshes
     : io::isPointCache(file) ? sorted.caches
                              : sorted.others)
        .push_back(file);
  }
  return sorted;
}

DroppedFiles joinedWith(const scene::SceneDescription& present, DroppedFiles files) {
  if (files.meshes.size() != 1 || !files.scenes.empty()) {
    return files;
  }
  const std::string dropped = files.meshes.front();
  const std::string cloth = present.parts.cloth.empty() ? present.parts.scene : present.parts.cloth;
  if (present.opened && present.bodies.empty() && isBody(files, dropped) && cloth != dropped) {
    files.meshes = {cloth, dropped};
  } else if (present.opened && !present.parts.bodies.empty() && !isBody(files, dropped)) {
    files.meshes.insert(files.meshes.end(), present.parts.bodies.begin(), present.parts.bodies.end());
  } else if (!present.opened && hasMeshBody(present) && !isBody(files, dropped)) {
    files.scenes = {present.parts.scene};
  } else {
    return files;
  }
  files.alone = dropped;
  return files;
}

DropDecision decide(const DroppedFiles& files) {
  DropDecision decision;
  if (files.scenes.size() > 1) {
    const std::vector<std::string> left(files.scenes.begin(), files.scenes.end() - 1);
    decision.notice.append(" ", text::Sentence("Only the last scene is opened, not {}.", listOf(left)));
  }
  const std::size_t pieces = files.meshes.size() + (files.scenes.empty() ? 0 : 1);
  std::vector<std::string> unknown = files.others;
  if (pieces == 0 && !unknown.empty()) {
    decision.open = scene::SceneParts{.scene = unknown.front()};  // opening it says what is wrong with it
    unknown.erase(unknown.begin());
  } else if (pieces == 1) {
    decision.open = scene::SceneParts{.scene = files.scenes.empty() ? files.meshes.front() : files.scenes.back()};
  }
  if (pieces <= 1 && !files.caches.empty()) {
    decision.notice.append(
        " ", text::Sentence("Vertex caches move a body: drop garment, body and {} together.", listOf(files.caches)));
  }
  if (!unknown.empty()) {
    decision.notice.append(" ", text::Sentence("Neither scenes nor meshes, and not opened: {}.", listOf(unknown)));
  }
  decision.ask = pieces > 1;
  return decision;
}

scene::SceneParts partsWithCloth(const DroppedFiles& files, std::size_t cloth) {
  scene::SceneParts parts;
  parts.caches = files.caches;
  if (!files.scenes.empty()) {
    parts.scene = files.scenes.back();
  }
  for (std::size_t i = 0; i < files.meshes.size(); ++i) {
    if (i == cloth) {
      parts.cloth = files.meshes[i];
    } else {
      parts.bodies.push_back(files.meshes[i]);
    }
  }
  return parts;
}

std::size_t likelyCloth(const DroppedFiles& files) {
  if (!files.alone.empty()) {
    return 0;
  }
  if (!files.scenes.empty()) {
    return files.meshes.size();
  }
  const auto found =
      std::ranges::find_if_not(files.meshes, [&](const std::string& file) { return isBody(files, file); });
  return found == files.meshes.end() ? 0 : static_cast<std::size_t>(found - files.meshes.begin());
}

}  // namespace drape::ui
