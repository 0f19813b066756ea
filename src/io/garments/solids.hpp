#pragma once

#include "io/mesh_import.hpp"

#include <vector>

namespace drape::io {

/// A point of the silhouette of a solid of revolution.
struct SilhouettePoint {
  double radius = 0.0;  ///< from the y axis [m]
  double height = 0.0;  ///< [m]
};

/// Adds the solid of revolution of a silhouette, from bottom to top, about the y axis.
void addTurned(const std::vector<SilhouettePoint>& silhouette, int segments, RawMesh& solid);

/// A quarter of a circle as part of a silhouette, between two points. With `outwardFirst` it starts horizontally (the
/// corner bulges outwards and down), otherwise vertically.
[[nodiscard]] std::vector<SilhouettePoint> rounding(SilhouettePoint from, SilhouettePoint to, bool outwardFirst);

/// Adds a round bar along points without sharp turns. An open bar gets rounded ends.
void addBar(const std::vector<Vec3>& path, bool closed, double radius, int segments, RawMesh& solid);

}  // namespace drape::io
