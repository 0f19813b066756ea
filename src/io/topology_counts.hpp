#pragma once

#include "sim/model/vector.hpp"

#include <cstddef>
#include <vector>

namespace drape::io {

/// Numbers that describe the topology of a triangle mesh.
struct TopologyCounts {
  int edges = 0;
  int components = 0;        ///< connected sets of vertices; a vertex without edges is one
  int boundaryLoops = 0;     ///< connected chains of edges with one face; chains that share a vertex count once
  int nonManifoldEdges = 0;  ///< edges with more than two faces
  int misorientedEdges = 0;  ///< edges whose two faces run in the same direction
};

/// Counts for `triangles` over `vertexCount` vertices. All indices must be in range. Cost: linear in the faces, plus
/// sorting the neighbours of each vertex.
[[nodiscard]] TopologyCounts countTopology(std::size_t vertexCount, const std::vector<Triangle>& triangles);

}  // namespace drape::io
