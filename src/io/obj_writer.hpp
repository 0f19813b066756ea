#pragma once

#include "io/mesh_import.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace drape::io {

/// A mesh as the text of an OBJ file: `positions` [m], one per particle, with the texture coordinates and faces of
/// `render`. Seams exist in the texture only; the mesh stays connected. Without texture coordinates faces contain
/// positions only. Six decimals (a micrometre), with the same bytes on every machine and in every locale. `comment`
/// becomes the first line.
[[nodiscard]] std::string objText(const std::vector<Vec3>& positions, const RenderMesh& render,
                                  std::string_view comment);

}  // namespace drape::io
