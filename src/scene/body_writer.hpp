#pragma once

#include "scene/scene.hpp"
#include "scene/toml_text.hpp"

#include <filesystem>
#include <string>

namespace drape::scene {

/// A mesh file as the key `mesh` names it: "builtin:table.obj", a path relative to the folder where the file lies below
/// it, or an absolute path.
[[nodiscard]] std::string meshName(const MeshFileSource& source, const std::filesystem::path& folder);

/// Writes a table [[bodies]], which readBodies reads to the same body.
/// @param folder of the scene file  @param body in metres with y up
void writeBody(const BodyDescription& body, const std::filesystem::path& folder, TomlText& toml);

/// Writes the friction and thickness of a body where they differ from the defaults.
void writeSurface(const sim::contact::SurfaceProperties& surface, TomlText& toml);

}  // namespace drape::scene
