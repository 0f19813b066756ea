#pragma once

#include "scene/scene.hpp"
#include "scene/toml_reader.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// Reads the tables [[bodies]] of a scene (docs/guide/scenes.md). Throws InputError with file and line.
/// @param folder that the names of mesh files are relative to
[[nodiscard]] std::vector<BodyDescription> readBodies(const TomlReader& scene, const std::filesystem::path& folder);

/// The friction and thickness that a table gives to a body.
void readSurface(const TomlReader& table, Body& body);

/// The keys that readSurface reads.
inline constexpr std::array<std::string_view, 3> surfaceKeys{"static_friction", "kinetic_friction", "thickness"};

/// The mesh file that a table names under `mesh`: "builtin:table.obj", or a file relative to the folder. Throws
/// InputError with file and line when there is no name.
[[nodiscard]] MeshFileSource meshSource(const TomlReader& table, const std::filesystem::path& folder);

}  // namespace drape
