#pragma once

#include "sim/cloth_model.hpp"
#include "sim/workers.hpp"

namespace drape {

/// The springs in colours, such that no two of one colour share a vertex: row c holds the springs of colour c,
/// ascending. Greedy in the order of the springs, so the same for the same mesh; with D springs at the vertex that has
/// most, at most 2 D - 1 colours. What changes both ends of a spring can take the springs of a colour in parallel and
/// still give the same bits for any number of threads.
[[nodiscard]] RaggedRows<int> colourSprings(const ClothModel& model);

/// The vertices in colours, such that no two of one colour share a spring: row c holds the vertices of colour c,
/// ascending. Greedy in the order of the vertices; at most D + 1 colours.
[[nodiscard]] RaggedRows<int> colourVertices(const ClothModel& model);

/// Calls visit(i) for every index, one colour after the other, within a colour on several threads.
template <typename Visit>
void forEachByColour(Workers& workers, int threads, const RaggedRows<int>& colours, Visit&& visit) {
  for (std::size_t c = 0; c + 1 < colours.begin.size(); ++c) {
    const int* first = colours.values.data() + colours.begin[c];
    const int count = colours.begin[c + 1] - colours.begin[c];
    workers.forEach(threads, static_cast<std::size_t>(count),
                    [&](std::size_t i) { visit(static_cast<std::size_t>(first[i])); });
  }
}

}  // namespace drape
