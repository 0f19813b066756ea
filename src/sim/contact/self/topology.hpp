#pragma once

#include "sim/cloth_model.hpp"

#include <array>
#include <vector>

namespace drape {

/// For each triangle the three across its edges: entry c lies across the edge from corner c to corner c + 1. -1 where
/// that edge is a border, belongs to more than two triangles, or is run through in the same direction by both, so that
/// the surface has no common front there.
[[nodiscard]] std::vector<std::array<int, 3>> trianglesAcross(const std::vector<Triangle>& triangles);

}  // namespace drape
