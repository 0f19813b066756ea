#include "sim/contact/closest_features/cloth_features.hpp"

#include "sim/model/mesh_topology.hpp"

namespace drape::sim::contact {

std::vector<OwnedFeatures> ownedFeatures(const std::vector<Triangle>& triangles, std::size_t vertexCount) {
  std::vector<OwnedFeatures> owned(triangles.size());
  std::vector<bool> taken(vertexCount, false);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      owned[t].corners[k] = !taken[triangles[t][k]];
      taken[triangles[t][k]] = true;
    }
  }
  const MeshEdges mesh = edgesOf(triangles, vertexCount);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const TriangleSide& first = mesh.sides[e].front();
    owned[first.triangle].sides[first.corner] = true;
  }
  return owned;
}

}  // namespace drape::sim::contact
