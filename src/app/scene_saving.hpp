#pragma once

#include "app/output_file.hpp"
#include "scene/scene_writer.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace drape::app {

/// The file that a path of the user means: absolute, and with the ending .toml if it has none. Throws InputError for
/// another ending.
[[nodiscard]] std::filesystem::path sceneFile(const std::filesystem::path& path);

/// Writes a scene file: beside the old one, which it then replaces, so that nothing is lost when this fails. Throws
/// InputError when the file exists and may not be replaced, or cannot be written.
/// @param file as sceneFile() returns it
/// @param start positions of the cloths at the start [m], which get a file "NAME_start.obj" beside the scene file;
/// empty: as in the scene
/// @return what the file cannot contain and which other files belong to it, one sentence each
std::vector<text::Sentence> saveScene(const scene::Scene& scene, scene::SceneNow now, const std::filesystem::path& file,
                                      Existing existing, const std::vector<Vec3>& start = {});

}  // namespace drape::app
