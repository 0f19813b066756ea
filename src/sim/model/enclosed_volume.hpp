#pragma once

#include "sim/model/vector.hpp"

#include <span>

namespace drape::sim {

/// The volume inside a surface that faces outwards [m^3]; negative if it faces inwards. The border of a hole counts as
/// if triangles joined it to the origin.
/// @param positions of the vertices [m]
inline double enclosedVolume(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                             const Vec3& origin = Vec3::Zero()) {
  double volume = 0.0;
  for (const auto& [a, b, c] : triangles) {
    volume += (positions[a] - origin).dot((positions[b] - origin).cross(positions[c] - origin)) / 6.0;
  }
  return volume;
}

}  // namespace drape::sim
