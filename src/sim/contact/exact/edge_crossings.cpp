#include "sim/contact/exact/edge_crossings.hpp"

#include "intersection/orientation.hpp"
#include "sim/contact/closest_features/triangle_geometry.hpp"

namespace drape::sim::contact {
namespace {

/// The signs are exact: with rounding errors, triangles of a flat part of the cloth would cross their neighbours.
bool passesThrough(const Vec3& from, const Vec3& to, const Corners& triangle) {
  using intersection::orientation;
  const auto& [a, b, c] = triangle;
  if (orientation(a, b, c, from) * orientation(a, b, c, to) >= 0) {
    return false;
  }
  const int first = orientation(from, to, a, b);
  const int second = orientation(from, to, b, c);
  const int third = orientation(from, to, c, a);
  return (first >= 0 && second >= 0 && third >= 0) || (first <= 0 && second <= 0 && third <= 0);
}

/// Adds the edges that belong to triangle a and pass through triangle b.
void addCrossings(const FeatureMesh& mesh, std::span<const Vec3> positions, int a, int b,
                  std::vector<EdgeCrossing>& crossings) {
  const FeatureMesh::Owned& owned = mesh.owned[a];
  const Triangle& triangle = mesh.triangles[b];
  for (int i = 0; i < owned.edgeCount; ++i) {
    const MeshEdge& edge = mesh.edges.edges[owned.edges[i]];
    if (!hasCorner(triangle, edge.a) && !hasCorner(triangle, edge.b) &&
        passesThrough(positions[edge.a], positions[edge.b], cornersOf(positions, triangle))) {
      crossings.push_back({owned.edges[i], b});
    }
  }
}

}  // namespace

void findCrossings(const FeatureMesh& mesh, MeshTree& tree, LeafBoxes& boxes, std::span<const Vec3> positions,
                   std::vector<EdgeCrossing>& crossings) {
  crossings.clear();
  tree.refit(positions, positions, mesh.triangles);
  boxes.fit(mesh, positions, positions);
  boxes.setPatches(nullptr);
  std::vector<OverlappingBoxes> overlaps;
  for (std::size_t leaf = 0; leaf < tree.leafCount(); ++leaf) {
    tree.forEachLeafIn(tree.leafBox(leaf), [&](std::size_t other) {
      if (other < leaf) {
        return;
      }
      findOverlaps(boxes.triangles(), leaf, boxes.triangles(), other, overlaps);
      for (const auto& [a, b] : overlaps) {
        addCrossings(mesh, positions, a, b, crossings);
        addCrossings(mesh, positions, b, a, crossings);
      }
    });
  }
}

void markEntangled(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings, std::size_t vertexCount,
                   std::vector<char>& entangled) {
  entangled.assign(crossings.empty() ? 0 : vertexCount, 0);
  for (const EdgeCrossing& crossing : crossings) {
    const MeshEdge& edge = mesh.edges.edges[crossing.edge];
    const Triangle& triangle = mesh.triangles[crossing.triangle];
    for (const int v : {edge.a, edge.b, triangle[0], triangle[1], triangle[2]}) {
      entangled[v] = 1;
    }
  }
}

}  // namespace drape::sim::contact
