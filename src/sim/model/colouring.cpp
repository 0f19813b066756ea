#include "sim/model/colouring.hpp"

#include <algorithm>
#include <vector>

namespace drape::sim {
namespace {

constexpr int none = -1;

/// The smallest colour that is free in `taken`. Grows `taken` to include it.
int smallestFree(std::vector<bool>& taken) {
  const auto found = std::find(taken.begin(), taken.end(), false);
  const auto colour = static_cast<int>(found - taken.begin());
  if (found == taken.end()) {
    taken.push_back(false);
  }
  return colour;
}

/// The indices of each colour, ascending. Those of no colour are left out.
RaggedRows<int> gatherByColour(const std::vector<int>& colourOf) {
  const int colours = colourOf.empty() ? 0 : *std::max_element(colourOf.begin(), colourOf.end()) + 1;
  return RaggedRows<int>::collect(colours, [&](const auto& add) {
    for (std::size_t i = 0; i < colourOf.size(); ++i) {
      if (colourOf[i] != none) {
        add(colourOf[i], static_cast<int>(i));
      }
    }
  });
}

/// Sets the entries of `taken` to `value` for the colours around a vertex. `index` maps a spring end to the item
/// (spring or neighbour) whose colour counts.
template <typename Index>
void setTaken(const RaggedRows<SpringEnd>& neighbours, std::size_t vertex, const std::vector<int>& colourOf,
              const Index& index, bool value, std::vector<bool>& taken) {
  for (const SpringEnd& end : neighbours[vertex]) {
    const int colour = colourOf[index(end)];
    if (colour != none) {
      taken[colour] = value;
    }
  }
}

}  // namespace

RaggedRows<int> colourSprings(const ClothModel& model) {
  std::vector<int> colourOf(model.springs.size(), none);
  std::vector<bool> taken;
  const auto springOf = [](const SpringEnd& end) { return end.spring; };
  for (std::size_t s = 0; s < model.springs.size(); ++s) {
    const int a = model.springs[s].a;
    const int b = model.springs[s].b;
    setTaken(model.springEnds, a, colourOf, springOf, true, taken);
    setTaken(model.springEnds, b, colourOf, springOf, true, taken);
    const int colour = smallestFree(taken);
    setTaken(model.springEnds, a, colourOf, springOf, false, taken);
    setTaken(model.springEnds, b, colourOf, springOf, false, taken);
    colourOf[s] = colour;
  }
  return gatherByColour(colourOf);
}

RaggedRows<int> colourVertices(const RaggedRows<SpringEnd>& neighbours) {
  std::vector<int> colourOf(neighbours.rowCount(), none);
  std::vector<bool> taken;
  const auto neighbourOf = [](const SpringEnd& end) { return end.neighbour; };
  for (std::size_t v = 0; v < colourOf.size(); ++v) {
    setTaken(neighbours, v, colourOf, neighbourOf, true, taken);
    const int colour = smallestFree(taken);
    setTaken(neighbours, v, colourOf, neighbourOf, false, taken);
    colourOf[v] = colour;
  }
  return gatherByColour(colourOf);
}

RaggedRows<int> colourSets(const RaggedRows<int>& sets, std::size_t vertexCount) {
  std::vector<int> colourOf(sets.rowCount(), none);
  std::vector<std::vector<int>> coloursAt(vertexCount);  // of the sets with that vertex
  std::vector<bool> taken;
  const auto setTakenAround = [&](std::size_t set, bool value) {
    for (const int vertex : sets[set]) {
      for (const int colour : coloursAt[vertex]) {
        taken[colour] = value;
      }
    }
  };
  for (std::size_t s = 0; s < colourOf.size(); ++s) {
    if (sets[s].empty()) {
      continue;
    }
    setTakenAround(s, true);
    const int colour = smallestFree(taken);
    setTakenAround(s, false);
    colourOf[s] = colour;
    for (const int vertex : sets[s]) {
      coloursAt[vertex].push_back(colour);
    }
  }
  return gatherByColour(colourOf);
}

}  // namespace drape::sim
