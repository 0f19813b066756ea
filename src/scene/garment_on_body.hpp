#pragma once

#include "scene/scene.hpp"

#include <string>

namespace drape::scene {

/// Whether this is the name of a built-in garment ("builtin:tshirt.obj") or body ("mannequin") instead of a file.
[[nodiscard]] bool isBuiltInWear(const std::string& name);

/// A body from a mesh file, in the unit and with the up axis that are guessed for it alone; or a built-in body. It
/// keeps the coordinates of its file. Throws InputError if the file is no mesh or cannot be read.
[[nodiscard]] BodyDescription bodyOfFile(const std::string& body, const settings::Settings& settings);

/// A scene of a garment and the body that is to wear it. The garment has no pins, and both have the coordinates of
/// their files. Unit and up axis of both are guessed where the format does not state them.
/// @param garment a mesh file, or a built-in one: "builtin:tshirt.obj"  @param body a mesh file, or a built-in body:
/// "mannequin" or "figure" Throws InputError as openScene, and for files that are no meshes.
[[nodiscard]] SceneDescription openGarmentOnBody(const std::string& garment, const std::string& body,
                                                 const settings::OwnFabrics& own = {});

}  // namespace drape::scene
