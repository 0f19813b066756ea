#pragma once

#include "sim/fabric/rest_shape.hpp"
#include "sim/model/cloth_model.hpp"

#include <span>
#include <vector>

namespace drape::sim::fields {

/// What fields need of a cloth and what does not change while it moves.
struct FieldGeometry {
  std::vector<fabric::RestTriangle> rest;  ///< of each triangle, along warp and weft
  std::vector<bool> onBorder;              ///< of each vertex: whether it lies on the border of the mesh
};

/// @param warp of a cloth of springs: a direction in the plane of each triangle at rest. A fabric knows its own.
[[nodiscard]] FieldGeometry fieldGeometryOf(const ClothModel& model, std::span<const Vec3> warp);

}  // namespace drape::sim::fields
