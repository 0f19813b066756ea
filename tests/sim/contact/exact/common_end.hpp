#pragma once

#include "sim/contact/exact/feature_mesh.hpp"

namespace drape::sim::testing {

/// Whether two edges have a common end.
inline bool shareEnd(const MeshEdge& first, const MeshEdge& second) {
  return first.a == second.a || first.a == second.b || first.b == second.a || first.b == second.b;
}

}  // namespace drape::sim::testing
