#include "sim/pieces.hpp"

#include <algorithm>

namespace drape {
namespace {

/// The vertices that springs connect to `first`, ascending. Marks them as seen.
std::vector<std::size_t> pieceAround(const ClothModel& model, std::size_t first, std::vector<bool>& seen) {
  std::vector<std::size_t> piece{first};
  seen[first] = true;
  for (std::size_t next = 0; next < piece.size(); ++next) {
    const auto begin = static_cast<std::size_t>(model.springEnds.begin[piece[next]]);
    const auto end = static_cast<std::size_t>(model.springEnds.begin[piece[next] + 1]);
    for (std::size_t e = begin; e < end; ++e) {
      const auto neighbour = static_cast<std::size_t>(model.springEnds.values[e].neighbour);
      if (!seen[neighbour]) {
        seen[neighbour] = true;
        piece.push_back(neighbour);
      }
    }
  }
  std::sort(piece.begin(), piece.end());
  return piece;
}

}  // namespace

std::vector<std::vector<std::size_t>> freePieces(const ClothModel& model) {
  std::vector<std::vector<std::size_t>> pieces;
  std::vector<bool> seen(model.restPositions.size(), false);
  for (std::size_t v = 0; v < seen.size(); ++v) {
    if (seen[v]) {
      continue;
    }
    std::vector<std::size_t> piece = pieceAround(model, v, seen);
    if (std::none_of(piece.begin(), piece.end(), [&](std::size_t member) { return model.pinned[member]; })) {
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

}  // namespace drape
