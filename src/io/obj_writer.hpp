#pragma once

#include "io/mesh_import.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// A mesh as the text of an OBJ file: `positions` [m], one a particle, and the texture coordinates and faces of
/// `render`, so that the seams are those of the texture and the mesh still hangs together. Without texture coordinates
/// faces name positions only. Six decimals (a micrometre), in the same bytes on every machine and in every language
/// setting. `comment` goes into the first line.
[[nodiscard]] std::string objText(const std::vector<Vec3>& positions, const RenderMesh& render,
                                  std::string_view comment);

}  // namespace drape
