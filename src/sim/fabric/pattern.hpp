#pragma once

#include "sim/fabric/membrane.hpp"
#include "sim/fabric/rest_shape.hpp"
#include "sim/model/cloth_model.hpp"

#include <memory>
#include <span>

namespace drape::sim::fabric {

/// The same cloth with the rest lengths and areas of a sewing pattern instead of those of its mesh. The length of a
/// spring is the mean of its triangles' sides, which differ at a seam where one piece is eased into the other. Masses
/// do not change. @param pattern one for each triangle of the cloth
/// Throws ClothModelError if there are more or fewer.
[[nodiscard]] std::shared_ptr<const ClothModel> withPattern(const ClothModel& model,
                                                            std::span<const RestTriangle> pattern);

/// How much a mesh is strained against a pattern. The strain of a triangle is the larger |stretch - 1| of its two
/// principal stretches. Triangles without area in the pattern do not count.
struct MeshStrain {
  double median = 0.0;  ///< [-]
  double high = 0.0;    ///< one triangle in 100 has more [-]
};
[[nodiscard]] MeshStrain meshStrain(const ClothModel& model, std::span<const RestTriangle> pattern);

/// A triangle of a pattern, turned in space as near as possible to the mesh. Its principal stretches are those of the
/// mesh, with 1 + s for 1 - s because cloth that is let go swings back as far, and at most `maxStretch`. 1: unstressed.
/// @return its corners relative to the first one; all zero for a triangle without area
[[nodiscard]] Corners placedInSpace(const RestTriangle& rest, const Corners& mesh, double maxStretch);

}  // namespace drape::sim::fabric
