#pragma once

#include "sim/model/vector.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace drape::sim {

/// The largest distance of a vertex from itself in other positions [m]; 0 without vertices.
/// @param from and to positions, one per vertex [m]
[[nodiscard]] inline double largestDistance(std::span<const Vec3> from, std::span<const Vec3> to) {
  double largest = 0.0;  // squared
  for (std::size_t v = 0; v < from.size(); ++v) {
    largest = std::max(largest, (to[v] - from[v]).squaredNorm());
  }
  return std::sqrt(largest);
}

}  // namespace drape::sim
