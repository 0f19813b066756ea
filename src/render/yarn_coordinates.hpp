#pragma once

#include "io/mesh_import.hpp"
#include "sim/model/vector.hpp"

#include <span>
#include <vector>

namespace drape::render {

/// Where the yarns of a fabric run: for each render vertex its place along weft (x) and warp (y) at rest [m], for
/// fabric.warp_angle = 0.
///
/// The coordinates are an affine map of the texture coordinates, one for each connected piece of the texture: the
/// area-weighted mean over its triangles. They are right to scale and in direction where the texture is a flat pattern
/// of the cloth. Empty when the mesh has no texture coordinates.
/// @param warp a unit vector in each triangle (scene::warpDirections); zero for a degenerate triangle
[[nodiscard]] std::vector<Vec2> yarnCoordinates(const io::RenderMesh& mesh, std::span<const Vec3> restPositions,
                                                std::span<const Vec3> warp);

}  // namespace drape::render
