#pragma once

#include "sim/model/cloth_model.hpp"

#include <array>
#include <vector>

namespace drape::sim::contact {

/// The three neighbours of each triangle: neighbour c shares the edge from corner c to corner c + 1. It is -1 if that
/// edge is a border, belongs to more than two triangles, or has the same direction in both, so that the two are
/// oriented inconsistently.
[[nodiscard]] std::vector<std::array<int, 3>> trianglesAcross(const std::vector<Triangle>& triangles,
                                                              std::size_t vertexCount);

}  // namespace drape::sim::contact
