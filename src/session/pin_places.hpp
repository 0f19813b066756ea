#pragma once

#include "sim/model/cloth_state.hpp"

#include <vector>

namespace drape::session {

/// Moves vertices to places [m], one each, and stops them.
void placeVertices(const std::vector<int>& vertices, const std::vector<Vec3>& places, sim::ClothState& state);

}  // namespace drape::session
