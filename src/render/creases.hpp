#pragma once

#include "sim/model/vector.hpp"

#include <span>
#include <vector>

namespace drape::render {

/// A mesh with vertices split along its sharp edges.
struct CreasedMesh {
  std::vector<Vec3> positions;  ///< [m]
  std::vector<Triangle> triangles;
};

/// Splits the vertices along edges whose faces turn by more than `angle` [rad]. Normals are then smooth on round parts
/// and sharp at rims.
[[nodiscard]] CreasedMesh splitAtCreases(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                                         double angle);

}  // namespace drape::render
