#pragma once

#include "sim/contact/self/float_lanes.hpp"
#include "sim/vector.hpp"

#include <vector>

namespace drape::testing {

/// Positions as self-collision takes them.
inline PlaceLanes lanesOf(const std::vector<Vec3>& positions) {
  PlaceLanes places;
  places.resize(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    places.x[v] = static_cast<float>(positions[v].x());
    places.y[v] = static_cast<float>(positions[v].y());
    places.z[v] = static_cast<float>(positions[v].z());
  }
  return places;
}

}  // namespace drape::testing
