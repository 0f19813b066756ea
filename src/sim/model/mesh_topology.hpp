#pragma once

#include "sim/model/disjoint_sets.hpp"
#include "sim/model/ragged_rows.hpp"
#include "sim/model/vector.hpp"

#include <compare>
#include <cstddef>
#include <span>
#include <vector>

namespace drape::sim {

/// An edge between two vertices, the lower one first.
struct MeshEdge {
  int a = 0;  ///< vertex index, a < b
  int b = 0;  ///< vertex index

  friend auto operator<=>(const MeshEdge&, const MeshEdge&) = default;
};

/// A side of a triangle: the edge from a corner to the next one.
struct TriangleSide {
  int triangle = 0;
  int corner = 0;          ///< the first one, 0 to 2
  bool ascending = false;  ///< from the lower vertex of the edge to the higher one
};

/// The edges of a mesh.
struct MeshEdges {
  std::vector<MeshEdge> edges;     ///< sorted by (a, b), each once
  RaggedRows<TriangleSide> sides;  ///< the sides of triangles on each edge, by ascending triangle and corner

  /// Whether the edge is on the boundary: it belongs to one triangle.
  [[nodiscard]] bool onBoundary(std::size_t edge) const { return sides[edge].size() == 1; }
};

/// Finds the edges of triangles with indices below `vertexCount`. A side whose ends are the same vertex is no edge.
/// Cost: linear in the triangles, plus sorting the edges at each vertex.
[[nodiscard]] MeshEdges edgesOf(std::span<const Triangle> triangles, std::size_t vertexCount);

/// The edges on the boundary, sorted by (a, b).
[[nodiscard]] std::vector<MeshEdge> boundaryEdges(const MeshEdges& mesh);

/// The triangles of each vertex, ascending. A triangle is listed once for each of its corners at the vertex.
[[nodiscard]] RaggedRows<int> trianglesOfVertices(std::span<const Triangle> triangles, std::size_t vertexCount);

/// Calls visit(from, to) for the sides of all triangles, triangle by triangle.
template <typename Visit>
void forEachSide(std::span<const Triangle> triangles, Visit&& visit) {
  for (const Triangle& triangle : triangles) {
    visit(triangle[0], triangle[1]);
    visit(triangle[1], triangle[2]);
    visit(triangle[2], triangle[0]);
  }
}

/// The connected components of a mesh, ordered by their lowest vertices.
struct ConnectedComponents {
  std::vector<int> componentOf;   ///< of each vertex
  std::vector<int> lowestVertex;  ///< of each component

  [[nodiscard]] int count() const { return static_cast<int>(lowestVertex.size()); }
  /// The vertices of each component, ascending.
  [[nodiscard]] RaggedRows<int> vertices() const { return indicesByRow(componentOf, lowestVertex.size()); }
};

/// The sets of vertices as components.
[[nodiscard]] ConnectedComponents componentsOf(DisjointSets& sets);

/// The sets of vertices that triangles connect. A vertex without triangles is a component.
[[nodiscard]] ConnectedComponents componentsOf(std::span<const Triangle> triangles, std::size_t vertexCount);

/// Joins the sets of a triangle's corners.
inline void joinCorners(const Triangle& triangle, DisjointSets& sets) {
  sets.join(triangle[0], triangle[1]);
  sets.join(triangle[0], triangle[2]);
}

}  // namespace drape::sim
