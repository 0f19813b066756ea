#pragma once

#include "sim/model/cloth_model.hpp"

#include <span>

namespace drape::sim {

/// The normal of a triangle at the given positions, with twice its area as length [m^2].
[[nodiscard]] Vec3 doubleAreaNormal(const Triangle& triangle, std::span<const Vec3> positions);

/// The unit normal of a vertex at the given positions: the mean of its triangles' normals, weighted by area. Zero if
/// they cancel or have no area.
[[nodiscard]] Vec3 vertexNormal(const ClothModel& model, std::span<const Vec3> positions, int vertex);

}  // namespace drape::sim
