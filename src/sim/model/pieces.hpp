#pragma once

#include "sim/model/cloth_model.hpp"

#include <vector>

namespace drape::sim {

/// The free pieces of a cloth: connected components of the spring graph without pinned vertices. Pieces are in the
/// order of their first vertices, vertices ascending.
[[nodiscard]] std::vector<std::vector<std::size_t>> freePieces(const ClothModel& model);

}  // namespace drape::sim
