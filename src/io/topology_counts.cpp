#include "io/topology_counts.hpp"

#include "sim/model/mesh_topology.hpp"

#include <span>

namespace drape::io {
namespace {

/// Counts the chains of boundary edges.
int countChains(std::size_t vertexCount, const std::vector<sim::MeshEdge>& edges) {
  sim::DisjointSets sets(vertexCount);
  std::vector<bool> onBoundary(vertexCount, false);
  int chains = 0;
  for (const sim::MeshEdge& edge : edges) {
    for (const int vertex : {edge.a, edge.b}) {
      if (!onBoundary[vertex]) {
        onBoundary[vertex] = true;
        ++chains;
      }
    }
    chains -= sets.join(edge.a, edge.b) ? 1 : 0;
  }
  return chains;
}

}  // namespace

TopologyCounts countTopology(std::size_t vertexCount, const std::vector<Triangle>& triangles) {
  const sim::MeshEdges mesh = sim::edgesOf(triangles, vertexCount);
  TopologyCounts counts;
  counts.edges = static_cast<int>(mesh.edges.size());
  counts.components = sim::componentsOf(triangles, vertexCount).count();
  counts.boundaryLoops = countChains(vertexCount, sim::boundaryEdges(mesh));
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const std::span<const sim::TriangleSide> sides = mesh.sides[e];
    counts.nonManifoldEdges += sides.size() > 2 ? 1 : 0;
    counts.misorientedEdges += sides.size() == 2 && sides[0].ascending == sides[1].ascending ? 1 : 0;
  }
  return counts;
}

}  // namespace drape::io
