#pragma once

#include "sim/contact/self/float_lanes.hpp"
#include "sim/model/vector.hpp"

#include <vector>

namespace drape::sim::testing {

using namespace contact;

/// Positions in the form that self-collision uses.
inline PositionLanes lanesOf(const std::vector<Vec3>& positions) {
  PositionLanes lanes;
  lanes.resize(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    lanes.x[v] = static_cast<float>(positions[v].x());
    lanes.y[v] = static_cast<float>(positions[v].y());
    lanes.z[v] = static_cast<float>(positions[v].z());
  }
  return lanes;
}

}  // namespace drape::sim::testing
