#pragma once

#include "sim/model/vector.hpp"

#include <span>

namespace drape::sim {

/// The axis-aligned box around some points; empty (Eigen's isEmpty()) when there are none.
[[nodiscard]] inline Eigen::AlignedBox3d boundsOf(std::span<const Vec3> points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : points) {
    box.extend(point);
  }
  return box;
}

}  // namespace drape::sim
