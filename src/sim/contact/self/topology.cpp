#include "sim/contact/self/topology.hpp"

#include "sim/model/mesh_topology.hpp"

namespace drape::sim::contact {

std::vector<std::array<int, 3>> trianglesAcross(const std::vector<Triangle>& triangles, std::size_t vertexCount) {
  std::vector<std::array<int, 3>> across(triangles.size(), {-1, -1, -1});
  const MeshEdges mesh = edgesOf(triangles, vertexCount);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const std::span<const TriangleSide> sides = mesh.sides[e];
    const TriangleSide& first = sides.front();
    const TriangleSide& last = sides.back();
    if (sides.size() == 2 && first.ascending != last.ascending && first.triangle != last.triangle) {
      across[first.triangle][first.corner] = last.triangle;
      across[last.triangle][last.corner] = first.triangle;
    }
  }
  return across;
}

}  // namespace drape::sim::contact
