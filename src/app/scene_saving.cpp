#include "app/scene_saving.hpp"

#include "app/output_file.hpp"
#include "messages/error.hpp"

#include <system_error>

namespace drape::app {

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

std::vector<text::Sentence> saveScene(const scene::Scene& scene, const scene::SceneNow& now,
                                      const std::filesystem::path& file, Existing existing) {
  std::error_code error;
  if (existing == Existing::Refused && std::filesystem::exists(file, error)) {
    throw messages::InputError(file.string() + " exists already; give another name");
  }
  if (!std::filesystem::is_directory(file.parent_path(), error)) {
    throw messages::InputError("cannot save the scene: there is no folder " + file.parent_path().string());
  }
  scene::WrittenScene written = scene::writeScene(scene, now, file.parent_path());
  if (!replaceFile(file, written.text)) {
    throw messages::InputError("cannot save the scene in " + file.string() + "; check that the folder is writable");
  }
  return std::move(written.notes);
}

}  // namespace drape::app
