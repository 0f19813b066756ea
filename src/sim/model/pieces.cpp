#include "sim/model/pieces.hpp"

#include "sim/model/mesh_topology.hpp"

#include <algorithm>
#include <span>

namespace drape::sim {

std::vector<std::vector<std::size_t>> freePieces(const ClothModel& model) {
  DisjointSets sets(model.restPositions.size());
  for (const Spring& spring : model.springs) {
    sets.join(spring.a, spring.b);
  }
  const RaggedRows<int> vertices = componentsOf(sets).vertices();
  std::vector<std::vector<std::size_t>> pieces;
  for (std::size_t i = 0; i < vertices.rowCount(); ++i) {
    const std::span<const int> piece = vertices[i];
    if (std::none_of(piece.begin(), piece.end(), [&](int v) { return model.pinned[v]; })) {
      pieces.emplace_back(piece.begin(), piece.end());
    }
  }
  return pieces;
}

}  // namespace drape::sim
