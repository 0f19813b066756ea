#pragma once

#include "io/mesh_import.hpp"
#include "scene/cloth_part.hpp"
#include "sim/model/vector.hpp"

#include <span>
#include <vector>

namespace drape::render {

/// Texture coordinates in metres of cloth, so that a check has the same size on every cloth, for any layout of the
/// texture.
struct SurfaceCoordinates {
  std::vector<Vec2> metres;  ///< one per render vertex [m]
  double checkSize = 0.1;    ///< a round length, for about a dozen checks across the cloth [m]
};

/// Scales the texture coordinates of a mesh so that one unit along u and along v is one metre of the rest shape on
/// average.
[[nodiscard]] SurfaceCoordinates surfaceCoordinates(const io::RenderMesh& mesh, std::span<const Vec3> restPositions);

/// The same for each cloth of a mesh on its own. The checks have the size of those of the largest cloth.
[[nodiscard]] SurfaceCoordinates surfaceCoordinates(const io::RenderMesh& mesh,
                                                    std::span<const scene::ClothPart> cloths,
                                                    std::span<const Vec3> restPositions);

}  // namespace drape::render
