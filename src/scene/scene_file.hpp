#pragma once

#include "scene/scene.hpp"
#include "settings/own_fabrics.hpp"

#include <filesystem>
#include <string_view>

namespace drape::scene {

/// The format of scene files that this version writes, in their key `format`. It reads this one and earlier ones. A
/// file without the key has this format. Format 1: `self_collision` is "off" in a file that does not set it. Format 2:
/// it is "auto".
inline constexpr int sceneFormat = 2;

/// Reads a scene from TOML text (docs/guide/scenes.md). Mesh paths are relative to `folder`; "builtin:skirt.obj" names
/// a built-in mesh. Throws InputError with file and line.
/// @param name of the scene  @param file for messages  @param own the user's fabrics; those of the scene are added
[[nodiscard]] SceneDescription parseScene(std::string_view text, const std::string& name, const std::string& file,
                                          const std::filesystem::path& folder, const settings::OwnFabrics& own = {});

}  // namespace drape::scene
