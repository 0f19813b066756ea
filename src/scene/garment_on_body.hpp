#pragma once

#include "scene/scene.hpp"

#include <optional>
#include <string>

namespace drape::scene {

/// Whether this is the name of a built-in garment ("builtin:tshirt.obj") or body ("mannequin") instead of a file.
[[nodiscard]] bool isBuiltInWear(const std::string& name);

/// The mesh of a garment or a body: a file, or a built-in one.
[[nodiscard]] MeshFileSource wearSource(const std::string& name);

/// A body from a mesh file, or a built-in body. It keeps the coordinates of its file. Throws InputError if the file is
/// no mesh or cannot be read.
/// @param choice the unit and the up axis of the file; "auto" is guessed for it alone
[[nodiscard]] BodyDescription bodyOfFile(const std::string& body, const settings::Settings& settings,
                                         const ReadingChoice& choice = {});

/// A body that a clip in its file moves: within a second from the pose of its mesh into the clip, which loops. Throws
/// InputError if the file has no format with animations. @param clip its name; empty: the only one
/// @param choice the unit of a glTF file in another unit than metres; else the file states unit and up axis
[[nodiscard]] BodyDescription animatedBodyOfFile(const std::string& body, const std::string& clip,
                                                 const ReadingChoice& choice = {});

/// A scene of a garment and the body that is to wear it. The garment has no pins, and both have the coordinates of
/// their files. Unit and up axis of both are guessed where the format does not state them.
/// @param garment a mesh file, or a built-in one: "builtin:tshirt.obj"
/// @param body a mesh file, or a built-in body: "mannequin" or "figure"
/// @param bodyReading the unit and the up axis of the body
/// @param clip that moves the body (animatedBodyOfFile); absent: it stands
/// Throws InputError as openScene, and for files that are no meshes.
[[nodiscard]] SceneDescription openGarmentOnBody(const std::string& garment, const std::string& body,
                                                 const settings::OwnFabrics& own = {},
                                                 const ReadingChoice& bodyReading = {},
                                                 const std::optional<std::string>& clip = std::nullopt);

}  // namespace drape::scene
