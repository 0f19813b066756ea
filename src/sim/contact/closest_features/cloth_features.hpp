#pragma once

#include "sim/model/cloth_model.hpp"

#include <array>
#include <vector>

namespace drape::sim::contact {

/// Which corners and sides of a triangle belong to it, so that loops over triangles visit each vertex and each edge
/// once. Side k runs from corner k to corner k + 1.
struct OwnedFeatures {
  std::array<bool, 3> corners{};
  std::array<bool, 3> sides{};
};

/// One entry per triangle. A feature belongs to the first triangle that contains it.
[[nodiscard]] std::vector<OwnedFeatures> ownedFeatures(const std::vector<Triangle>& triangles, std::size_t vertexCount);

}  // namespace drape::sim::contact
