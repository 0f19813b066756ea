#pragma once

#include "sim/cloth_model.hpp"

#include <vector>

namespace drape {

/// The pieces of a cloth that nothing holds: sets of vertices that springs connect, without a pinned vertex among them.
/// Pieces in the order of their first vertex, vertices ascending.
[[nodiscard]] std::vector<std::vector<std::size_t>> freePieces(const ClothModel& model);

}  // namespace drape
