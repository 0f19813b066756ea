#pragma once

#include "io/mesh_import.hpp"

#include <vector>

namespace drape {

/// A point of a turned shape's silhouette.
struct SilhouettePoint {
  double radius = 0.0;  ///< from the y axis [m]
  double height = 0.0;  ///< [m]
};

/// Adds the solid that a silhouette, given from bottom to top, makes when it turns around the y axis.
void addTurned(const std::vector<SilhouettePoint>& silhouette, int segments, RawMesh& solid);

/// A quarter of a circle as part of a silhouette, from one point to the other. `outwardFirst`: it leaves the first
/// point level (so that the corner bulges outwards and down), else upright.
[[nodiscard]] std::vector<SilhouettePoint> rounding(SilhouettePoint from, SilhouettePoint to, bool outwardFirst);

/// Adds a round bar along points, which must not turn sharply. An open bar gets rounded ends.
void addBar(const std::vector<Vec3>& path, bool closed, double radius, int segments, RawMesh& solid);

}  // namespace drape
