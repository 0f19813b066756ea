#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/workers.hpp"

namespace drape::sim {

/// Colours the springs so that no two of one colour share a vertex. Row c has the springs of colour c, ascending.
/// Greedy in the order of the springs; at most 2 D - 1 colours, where D is the largest number of springs at a vertex.
/// Loops that change both ends of a spring can process one colour in parallel, with the same result for any number of
/// threads.
[[nodiscard]] RaggedRows<int> colourSprings(const ClothModel& model);

/// Colours the vertices so that no two of one colour are neighbours: share a spring, or are a pair of a fabric. Row c
/// has the vertices of colour c, ascending. Greedy in the order of the vertices; at most D + 1 colours.
/// @param neighbours of each vertex: ClothModel::springEnds or fabric::Fabric::pairEnds
[[nodiscard]] RaggedRows<int> colourVertices(const RaggedRows<SpringEnd>& neighbours);

/// Colours sets of vertices so that no two of one colour have a common vertex. Row c has the sets of colour c,
/// ascending. Greedy in the order of the sets. Empty sets are left out. @param sets the vertices of each set
[[nodiscard]] RaggedRows<int> colourSets(const RaggedRows<int>& sets, std::size_t vertexCount);

/// Calls visit(i) for every index, colour by colour; on several threads within a colour.
template <typename Visit>
void forEachByColour(Workers& workers, int threads, const RaggedRows<int>& colours, Visit&& visit) {
  for (std::size_t c = 0; c < colours.rowCount(); ++c) {
    const std::span<const int> row = colours[c];
    workers.forEach(threads, row.size(), [&](std::size_t i) { visit(static_cast<std::size_t>(row[i])); });
  }
}

}  // namespace drape::sim
