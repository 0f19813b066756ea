#pragma once

#include "scene/boundary_loops.hpp"
#include "sim/model/cloth_model.hpp"

#include <optional>
#include <vector>

namespace drape::dressing {

/// The neckline or the waistline of a garment that is open from top to bottom: of a cape, a jacket, or a wrap skirt.
struct OpenNeckline {
  std::vector<int> vertices;   ///< from one side of the gap to the other, in order
  double width = 0.0;          ///< its larger extent along x or z [m]
  Vec3 centre = Vec3::Zero();  ///< the mean of its vertices [m]
  Vec3 gap = Vec3::Zero();     ///< the middle of the straight line that closes it [m]
};

/// Finds the part of an outline near the top that goes around more than about half of a circle, seen from above.
/// None if the garment hangs or lies flat.
/// @param garment upright [m]  @param pieces of that mesh
[[nodiscard]] std::optional<OpenNeckline> findOpenNeckline(const sim::ClothMesh& garment,
                                                           const scene::ClothPieces& pieces);

}  // namespace drape::dressing
