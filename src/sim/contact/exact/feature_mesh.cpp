#include "sim/contact/exact/feature_mesh.hpp"

namespace drape::sim::contact {

FeatureMesh featureMeshOf(const ClothModel& model) {
  FeatureMesh mesh{.triangles = model.triangles,
                   .edges = edgesOf(model.triangles, model.restPositions.size()),
                   .edgesOfTriangle = {},
                   .owned = std::vector<FeatureMesh::Owned>(model.triangles.size())};
  mesh.edgesOfTriangle.assign(mesh.triangles.size(), {-1, -1, -1});
  for (std::size_t e = 0; e < mesh.edges.edges.size(); ++e) {
    for (const TriangleSide& side : mesh.edges.sides[e]) {
      mesh.edgesOfTriangle[side.triangle][side.corner] = static_cast<int>(e);
    }
    FeatureMesh::Owned& owner = mesh.owned[mesh.edges.sides[e].front().triangle];
    owner.edges[owner.edgeCount++] = static_cast<int>(e);
  }
  std::vector<bool> taken(model.restPositions.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int v : mesh.triangles[t]) {
      if (!taken[v]) {
        taken[v] = true;
        mesh.owned[t].vertices[mesh.owned[t].vertexCount++] = v;
      }
    }
  }
  return mesh;
}

}  // namespace drape::sim::contact
