#pragma once

#include "sim/model/cloth_model.hpp"

#include <span>
#include <vector>

namespace drape::dressing {

/// The share of some of the points that are inside a closed surface [-]: those whose winding number is above one half.
/// Parts of the surface may overlap. @param positions of the surface [m]
[[nodiscard]] double shareInside(std::span<const Vec3> points, std::span<const Vec3> positions,
                                 std::span<const Triangle> triangles);

}  // namespace drape::dressing
