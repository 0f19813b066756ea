#pragma once

#include "scene/boundary_loops.hpp"
#include "sim/model/cloth_model.hpp"

#include <optional>
#include <vector>

namespace drape::scene {

/// The neckline or the waistline of a garment that is open from top to bottom: of a cape, a jacket, or a wrap skirt.
struct OpenNeckline {
  std::vector<int> vertices;   ///< from one side of the gap to the other, in order
  double width = 0.0;          ///< its larger horizontal extent, in units of the mesh
  Vec3 centre = Vec3::Zero();  ///< the mean of its vertices
  Vec3 gap = Vec3::Zero();     ///< the middle of the straight line that closes it
};

/// Finds the part of an outline near the top that goes around more than about half of a circle, seen from above.
/// None if the garment hangs or lies flat.
/// @param pieces of that mesh  @param up the axis that points up: 0 for x, 1 for y, 2 for z
[[nodiscard]] std::optional<OpenNeckline> findOpenNeckline(const sim::ClothMesh& garment, const ClothPieces& pieces,
                                                           int up = 1);

}  // namespace drape::scene
