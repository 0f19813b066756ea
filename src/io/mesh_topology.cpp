#include "io/mesh_topology.hpp"

#include "sim/disjoint_sets.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace drape {
namespace {

/// A side of a face, stored at its lower vertex.
struct Side {
  int other = 0;          ///< the higher vertex
  bool ascending = true;  ///< the face runs from the lower vertex to the higher one
};

/// The sides of all faces, grouped by lower vertex and sorted by the higher vertex within a group.
struct SideTable {
  std::vector<std::size_t> begin;  ///< vertices + 1 entries
  std::vector<Side> sides;
};

SideTable sortSides(int vertexCount, const std::vector<Triangle>& triangles) {
  SideTable table;
  table.begin.assign(static_cast<std::size_t>(vertexCount) + 1, 0);
  const auto forEachSide = [&triangles](auto&& visit) {
    for (const Triangle& triangle : triangles) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        visit(triangle[corner], triangle[(corner + 1) % 3]);
      }
    }
  };
  forEachSide([&table](int from, int to) { ++table.begin[static_cast<std::size_t>(std::min(from, to)) + 1]; });
  std::partial_sum(table.begin.begin(), table.begin.end(), table.begin.begin());
  table.sides.resize(triangles.size() * 3);
  std::vector<std::size_t> cursor(table.begin.begin(), table.begin.end() - 1);
  forEachSide([&table, &cursor](int from, int to) {
    table.sides[cursor[static_cast<std::size_t>(std::min(from, to))]++] = {std::max(from, to), from < to};
  });
  for (std::size_t row = 0; row + 1 < table.begin.size(); ++row) {
    const auto first = table.sides.begin();
    std::sort(first + static_cast<std::ptrdiff_t>(table.begin[row]),
              first + static_cast<std::ptrdiff_t>(table.begin[row + 1]), [](const Side& a, const Side& b) {
                return std::pair(a.other, a.ascending) < std::pair(b.other, b.ascending);
              });
  }
  return table;
}

/// Counts one edge; the sides of its faces are sides[first] .. sides[last - 1].
void countEdge(const std::vector<Side>& sides, std::size_t first, std::size_t last, MeshTopology& topology) {
  ++topology.edges;
  if (last - first > 2) {
    ++topology.nonManifoldEdges;
  } else if (last - first == 2 && sides[first].ascending == sides[first + 1].ascending) {
    ++topology.misorientedEdges;
  }
}

/// Counts the chains of boundary edges.
int countChains(int vertexCount, const std::vector<std::pair<int, int>>& edges) {
  DisjointSets sets(vertexCount);
  std::vector<bool> onBoundary(static_cast<std::size_t>(vertexCount), false);
  int chains = 0;
  for (const auto& [a, b] : edges) {
    for (const int vertex : {a, b}) {
      if (!onBoundary[static_cast<std::size_t>(vertex)]) {
        onBoundary[static_cast<std::size_t>(vertex)] = true;
        ++chains;
      }
    }
    chains -= sets.join(a, b) ? 1 : 0;
  }
  return chains;
}

}  // namespace

MeshTopology measureTopology(int vertexCount, const std::vector<Triangle>& triangles) {
  const SideTable table = sortSides(vertexCount, triangles);
  MeshTopology topology;
  topology.components = vertexCount;
  DisjointSets pieces(vertexCount);
  std::vector<std::pair<int, int>> boundary;
  for (int low = 0; low < vertexCount; ++low) {
    const std::size_t end = table.begin[static_cast<std::size_t>(low) + 1];
    for (std::size_t first = table.begin[static_cast<std::size_t>(low)]; first < end;) {
      const int high = table.sides[first].other;
      std::size_t last = first;
      while (last < end && table.sides[last].other == high) {
        ++last;
      }
      countEdge(table.sides, first, last, topology);
      topology.components -= pieces.join(low, high) ? 1 : 0;
      if (last - first == 1) {
        boundary.emplace_back(low, high);
      }
      first = last;
    }
  }
  topology.boundaryLoops = countChains(vertexCount, boundary);
  return topology;
}

}  // namespace drape
