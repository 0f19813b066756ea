#include "ui/dropped_files.hpp"

#include "io/animation_import.hpp"
#include "io/mesh_import.hpp"
#include "io/point_cache_import.hpp"
#include "scene/reading_change.hpp"
#include "text/words.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace drape::ui {
namespace {

/// A name with the word of a body, and with none of a garment: "avatar_shirt.obj" is a garment.
bool hasBodyName(const std::string& file) {
  static constexpr std::array<std::string_view, 9> bodies{"body",   "avatar", "mannequin", "figure", "human",
                                                          "person", "woman",  "smpl",      "dummy"};
  static constexpr std::array<std::string_view, 10> garments{"shirt", "dress",  "skirt", "trouser", "pants",
                                                             "coat",  "jacket", "polo",  "blouse",  "garment"};
  const std::string name = text::lowerCase(shortName(file));
  const auto isInName = [&](std::string_view word) { return name.find(word) != std::string::npos; };
  return std::ranges::any_of(bodies, isInName) && std::ranges::none_of(garments, isInName);
}

/// A body by its name or its format, or since a vertex cache of its name moves it.
bool isBody(const DroppedFiles& files, const std::string& file) {
  const auto stem = [](const std::string& name) { return std::filesystem::path(name).stem(); };
  return hasBodyName(file) || io::isOnlyAnimationFile(file) ||
         std::ranges::any_of(files.caches, [&](const std::string& cache) { return stem(cache) == stem(file); });
}

bool hasMeshBody(const scene::SceneDescription& scene) {
  return std::ranges::any_of(scene.bodies, [](const scene::BodyDescription& body) { return !body.meshes.empty(); });
}

/// How the file of a body in the window is read; "auto" where that cannot be changed.
scene::ReadingChoice readingOfBody(const scene::Scene& scene, std::size_t body) {
  return scene::changeableReading(scene, {scene::Placeable::Kind::Body, body}).value_or(scene::ReadingChoice());
}

/// The file of the garment that was opened without a scene; empty if there is none.
std::string garmentIn(const scene::SceneDescription& description) {
  return !description.opened               ? std::string()
         : description.parts.cloth.empty() ? description.parts.scene
                                           : description.parts.cloth;
}

/// Whether the window has a garment without a body, other than that file.
bool isGarmentAlone(const scene::Scene& present, const std::string& other) {
  const std::string garment = garmentIn(present.description);
  return !garment.empty() && present.description.bodies.empty() && garment != other;
}

/// Whether the window has a figure without a garment, which is a cloth there, other than that file.
bool isFigureAlone(const scene::Scene& present, const std::string& other) {
  return present.summary.hasSkin && isGarmentAlone(present, other);
}

/// The garment in the window with a dropped body.
DroppedFiles joinedAsBody(const scene::Scene& present, DroppedFiles files) {
  files.alone = files.meshes.front();
  files.meshes = {garmentIn(present.description), files.alone};
  files.readings = {{present.settings.mesh.unit, present.settings.mesh.up}, {}};
  return files;
}

std::string listOf(const std::vector<std::string>& files) {
  std::string names;
  for (const std::string& file : files) {
    names += (names.empty() ? "" : ", ") + shortName(file);
  }
  return names;
}

/// What was found in the i-th mesh; null while that is not known.
const scene::FoundMesh* meshIn(const DroppedFiles& files, std::size_t i, std::span<const FoundFile> found) {
  const auto file = std::ranges::find(found, files.meshes[i], &FoundFile::file);
  return file != found.end() && file->mesh ? &*file->mesh : nullptr;
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
    names.push_back(same > 1 && !folder.empty() ? fmt::format("{} ({})", name, folder) : name);
  }
  return names;
}

DroppedFiles sortDropped(const std::vector<std::string>& files) {
  DroppedFiles sorted;
  for (const std::string& file : files) {
    const bool scene = text::lowerCase(std::filesystem::path(file).extension().string()) == ".toml";
    const bool mesh = io::isMeshFile(file) || io::isAnimationFile(file);
    (scene                    ? sorted.scenes
     : mesh                   ? sorted.meshes
     : io::isPointCache(file) ? sorted.caches
                              : sorted.others)
        .push_back(file);
  }
  return sorted;
}

std::optional<DroppedFiles> joinedIfBody(const scene::Scene& present, DroppedFiles files) {
  if (files.meshes.size() != 1 || !files.scenes.empty() || !isGarmentAlone(present, files.meshes.front()) ||
      present.summary.hasSkin) {
    return std::nullopt;
  }
  return joinedAsBody(present, std::move(files));
}

DroppedFiles joinedWith(const scene::Scene& present, DroppedFiles files) {
  const scene::SceneDescription& description = present.description;
  if (files.meshes.size() != 1 || !files.scenes.empty()) {
    return files;
  }
  const std::string dropped = files.meshes.front();
  const std::vector<std::string>& bodies = description.parts.bodies;
  if (isGarmentAlone(present, dropped) && isBody(files, dropped)) {
    return joinedAsBody(present, std::move(files));
  }
  if (isFigureAlone(present, dropped) && !isBody(files, dropped)) {
    files.meshes.push_back(garmentIn(description));
    files.readings = {{}, {present.settings.mesh.unit, present.settings.mesh.up}};
  } else if (description.opened && !bodies.empty() && !isBody(files, dropped)) {
    files.meshes.insert(files.meshes.end(), bodies.begin(), bodies.end());
    files.readings = {{}};
    files.motions = {{}};
    for (const std::optional<std::string>& clip : description.parts.bodyClips) {
      files.motions.push_back({true, clip});
    }
    const std::size_t first = description.bodies.size() - std::min(bodies.size(), description.bodies.size());
    for (std::size_t i = first; i < description.bodies.size(); ++i) {
      files.readings.push_back(readingOfBody(present, i));
    }
  } else if (!description.opened && hasMeshBody(description) && !isBody(files, dropped)) {
    files.scenes = {description.parts.scene};
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
  } else if (pieces == 1 && files.scenes.empty() && io::isOnlyAnimationFile(files.meshes.front())) {
    decision.notice.append(" ", text::Sentence("{} is a body: drop it together with a garment, or while a garment "
                                               "without a body is open.",
                                               shortName(files.meshes.front())));
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

DropChoices firstChoices(const DroppedFiles& files) {
  DropChoices choices{likelyCloth(files), files.readings, files.motions};
  choices.readings.resize(files.meshes.size());
  choices.motions.resize(files.meshes.size());
  return choices;
}

std::vector<std::optional<scene::MeshReading>> readingsBy(const DroppedFiles& files, const DropChoices& choices,
                                                          std::span<const FoundFile> found) {
  std::vector<std::optional<scene::MeshReading>> readings(files.meshes.size());
  const auto meshOf = [&](std::size_t i) { return meshIn(files, i, found); };
  scene::MeshReading cloth;  // that of a scene: in metres
  const bool isMesh = choices.cloth < files.meshes.size();
  if (isMesh && meshOf(choices.cloth) != nullptr) {
    cloth = scene::readingOf(*meshOf(choices.cloth), choices.readings.at(choices.cloth), io::MeshUse::Cloth);
    readings[choices.cloth] = cloth;
  }
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const bool isClothKnown = !isMesh || readings[choices.cloth];
    if (i != choices.cloth && meshOf(i) != nullptr && isClothKnown) {
      readings[i] = scene::readingBeside(*meshOf(i), choices.readings.at(i), cloth);
    }
  }
  return readings;
}

std::optional<std::string> clipBy(const DroppedFiles& files, const DropChoices& choices, std::size_t i,
                                  std::span<const FoundFile> found) {
  const scene::FoundMesh* mesh = meshIn(files, i, found);
  if (i == choices.cloth || mesh == nullptr || mesh->clips.empty()) {
    return std::nullopt;
  }
  if (const MotionChoice& choice = choices.motions.at(i); choice.isChosen) {
    return choice.clip;
  }
  return mesh->isOnlyAnimation || mesh->clips.size() == 1 ? std::optional(mesh->clips.front().name) : std::nullopt;
}

scene::SceneParts partsBy(const DroppedFiles& files, const DropChoices& choices, std::span<const FoundFile> found) {
  scene::SceneParts parts = partsWithCloth(files, choices.cloth);
  const std::vector<std::optional<scene::MeshReading>> readings = readingsBy(files, choices, found);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const scene::ReadingChoice reading =
        readings[i] ? scene::ReadingChoice{readings[i]->unit, readings[i]->up} : choices.readings.at(i);
    if (i == choices.cloth) {
      parts.clothReading = reading;
      continue;
    }
    parts.bodyClips.push_back(clipBy(files, choices, i, found));
    // A file with clips states its unit and its up axis; only a glTF file may be read in another unit.
    parts.bodyReadings.push_back(parts.bodyClips.back()
                                     ? scene::ReadingChoice{choices.readings.at(i).unit, scene::ReadingChoice().up}
                                     : reading);
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
