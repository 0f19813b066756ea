#pragma once

#include "sim/cloth_model.hpp"

#include <array>
#include <vector>

namespace drape {

/// Which of a triangle's corners and sides are looked at together with it, so that each vertex and each edge of the
/// cloth is looked at once. Side k goes from corner k to corner k + 1.
struct OwnedFeatures {
  std::array<bool, 3> corners{};
  std::array<bool, 3> sides{};
};

/// One for each triangle: it owns what no earlier triangle has.
[[nodiscard]] std::vector<OwnedFeatures> ownedFeatures(const std::vector<Triangle>& triangles, int vertexCount);

}  // namespace drape
