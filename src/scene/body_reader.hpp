#pragma once

#include "scene/scene.hpp"
#include "scene/toml_reader.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace drape::scene {

/// Reads the tables [[bodies]] of a scene (docs/guide/scenes.md). Throws InputError with file and line.
/// @param folder base of relative mesh file names
[[nodiscard]] std::vector<BodyDescription> readBodies(const TomlReader& scene, const std::filesystem::path& folder);

/// Reads the friction and thickness of a body from a table.
void readSurface(const TomlReader& table, sim::contact::Body& body);

/// The keys that readSurface reads.
inline constexpr std::array<std::string_view, 3> surfaceKeys{"static_friction", "kinetic_friction", "thickness"};

/// The mesh file in the key `mesh` of a table: "builtin:table.obj", or a file relative to the folder. Throws InputError
/// with file and line when there is no name.
[[nodiscard]] MeshFileSource meshSource(const TomlReader& table, const std::filesystem::path& folder);

}  // namespace drape::scene
