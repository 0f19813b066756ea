#include "app/scene_saving.hpp"

#include "app/exported_cloth.hpp"
#include "app/output_file.hpp"
#include "messages/error.hpp"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

namespace drape::app {
namespace {

/// Writes where one cloth is, in the unit and the axes of its mesh.
void writeStart(const scene::Scene& scene, std::size_t index, const std::vector<Vec3>& start,
                const std::filesystem::path& file) {
  scene::ClothPart cloth = scene.cloths[index];
  cloth.placement = cloth.startPlacement;
  const auto writer =
      io::animation::makeWriter([&](int) { return file; }, clipOf(scene, {index}, ExportCoordinates::File));
  writer->add({exportedShape(*scene.model, start, cloth, ExportCoordinates::File)});
  writer->finish();
}

/// Writes the starts of the cloths that are elsewhere than in the scene, beside its file.
/// @return the files, one per cloth
std::vector<std::optional<scene::MeshFileSource>> writeStarts(const scene::Scene& scene, const std::vector<Vec3>& start,
                                                              const std::filesystem::path& sceneFile, Existing existing,
                                                              std::vector<text::Sentence>& notes) {
  std::vector<std::optional<scene::MeshFileSource>> files;
  for (std::size_t i = 0; i < scene.cloths.size(); ++i) {
    files.push_back(scene.description.cloths[i].start);
    const scene::ClothPart& cloth = scene.cloths[i];
    const auto first = start.begin() + cloth.firstVertex;
    if (std::equal(first, first + cloth.vertexCount, scene.start.positions.begin() + cloth.firstVertex)) {
      continue;
    }
    const std::string name = scene.cloths.size() > 1 ? "_" + exportedName(scene, cloth) : "";
    const std::filesystem::path file = sceneFile.parent_path() / (sceneFile.stem().string() + "_start" + name + ".obj");
    requireFree(file, existing, "--replace");
    writeStart(scene, i, start, file);
    files.back() = scene::MeshFileSource{file.string()};
    notes.emplace_back("The start of the cloth is in {}", file.filename().string());
  }
  return files;
}

/// Whether a cloth has more vertices than its file.
bool isDivided(const scene::Scene& scene) {
  return std::ranges::any_of(scene.cloths, [&](const scene::ClothPart& cloth) {
    return scene::settingsOf(cloth.own, scene.settings).mesh.subdivide > 0;
  });
}

}  // namespace

std::filesystem::path sceneFile(const std::filesystem::path& path) {
  constexpr const char* ending = ".toml";
  std::filesystem::path file = std::filesystem::absolute(path).lexically_normal();
  if (!file.has_extension()) {
    file += ending;
  }
  if (file.extension() != ending || !file.has_stem()) {
    throw messages::InputError(path.string() + ": a scene file ends in " + ending);
  }
  return file;
}

std::vector<text::Sentence> saveScene(const scene::Scene& scene, scene::SceneNow now, const std::filesystem::path& file,
                                      Existing existing, const std::vector<Vec3>& start) {
  requireFree(file, existing, "--replace");
  std::error_code error;
  if (!std::filesystem::is_directory(file.parent_path(), error)) {
    throw messages::InputError("cannot save the scene: there is no folder " + file.parent_path().string());
  }
  std::vector<text::Sentence> more;
  if (!start.empty() && isDivided(scene)) {
    more.emplace_back("The cloth starts as in its mesh file, since it is divided (subdivide)");
  } else if (!start.empty()) {
    now.starts = writeStarts(scene, start, file, existing, more);
  }
  scene::WrittenScene written = scene::writeScene(scene, now, file.parent_path());
  if (!replaceFile(file, written.text)) {
    throw messages::InputError("cannot save the scene in " + file.string() + "; check that the folder is writable");
  }
  written.notes.insert(written.notes.end(), more.begin(), more.end());
  return std::move(written.notes);
}

}  // namespace drape::app
