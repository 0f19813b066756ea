#pragma once

#include "sim/vector.hpp"

#include <vector>

namespace drape {

/// The topology of a triangle mesh.
struct MeshTopology {
  int edges = 0;
  int components = 0;        ///< connected sets of vertices; a vertex without edges is one
  int boundaryLoops = 0;     ///< connected chains of edges with one face; chains that share a vertex count once
  int nonManifoldEdges = 0;  ///< edges with more than two faces
  int misorientedEdges = 0;  ///< edges whose two faces run in the same direction
};

/// Measures the topology of `triangles` over `vertexCount` vertices. All indices must be in range. Cost: linear in the
/// faces, plus sorting the neighbours of each vertex.
[[nodiscard]] MeshTopology measureTopology(int vertexCount, const std::vector<Triangle>& triangles);

}  // namespace drape
