#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/mesh_topology.hpp"

#include <array>
#include <vector>

namespace drape::sim::contact {

/// The vertices, edges and triangles of a cloth, as the features of its surface that can meet.
struct FeatureMesh {
  /// The corners and sides that belong to a triangle, so that a loop over triangles visits each vertex and edge once.
  struct Owned {
    std::array<int, 3> vertices{};  ///< the first `vertexCount`
    std::array<int, 3> edges{};     ///< the first `edgeCount`; indices into `edges`
    int vertexCount = 0;
    int edgeCount = 0;
  };

  std::vector<Triangle> triangles;
  MeshEdges edges;
  std::vector<std::array<int, 3>> edgesOfTriangle;  ///< side k runs from corner k; -1: its ends are the same vertex
  std::vector<Owned> owned;                         ///< one per triangle
};

[[nodiscard]] FeatureMesh featureMeshOf(const ClothModel& model);

/// Whether a vertex is a corner of a triangle.
[[nodiscard]] inline bool hasCorner(const Triangle& triangle, int vertex) {
  return triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex;
}

}  // namespace drape::sim::contact
