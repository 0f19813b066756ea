#pragma once

#include "sim/vector.hpp"

#include <vector>

namespace drape {

/// How the triangles of a mesh hang together.
struct MeshTopology {
  int edges = 0;
  int components = 0;        ///< sets of vertices joined by edges; a vertex without any is its own
  int boundaryLoops = 0;     ///< connected chains of edges with one face; two that share a vertex count once
  int nonManifoldEdges = 0;  ///< edges with more than two faces
  int misorientedEdges = 0;  ///< edges whose two faces run in the same direction
};

/// Counts what `triangles` over `vertexCount` vertices form. Every index must be in range.
/// Cost: linear in the faces, but for sorting the neighbours of each vertex.
[[nodiscard]] MeshTopology measureTopology(int vertexCount, const std::vector<Triangle>& triangles);

}  // namespace drape
