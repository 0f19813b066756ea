#pragma once

#include "io/mesh_import.hpp"
#include "sim/vector.hpp"

#include <span>
#include <vector>

namespace drape {

/// Texture coordinates in metres of cloth, so that a check is as wide on every cloth, whatever part of the texture
/// its pattern pieces fill.
struct SurfaceCoordinates {
  std::vector<Vec2> metres;  ///< one a render vertex [m]
  double checkSize = 0.1;    ///< a round length that gives about a dozen checks across the cloth [m]
};

/// Stretches the texture coordinates of a mesh so that one unit along u and along v is, in the mean, one metre of the
/// rest shape.
[[nodiscard]] SurfaceCoordinates surfaceCoordinates(const RenderMesh& mesh, std::span<const Vec3> restPositions);

}  // namespace drape
