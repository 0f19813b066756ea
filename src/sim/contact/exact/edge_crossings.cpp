#include "sim/contact/exact/edge_crossings.hpp"

#include "intersection/orientation.hpp"
#include "sim/contact/closest_features/triangle_geometry.hpp"

namespace drape::sim::contact {
namespace {

/// Whether an edge has its ends on different sides of a triangle and passes through it. The test is exact: with
/// rounding errors, neighbours in a flat part of the cloth would cross.
bool passesThrough(const Vec3& from, const Vec3& to, const Corners& triangle) {
  const auto sideOf = [&](const Vec3& point) {
    return intersection::orientation(triangle[0], triangle[1], triangle[2], point);
  };
  return sideOf(from) * sideOf(to) < 0 && intersection::isPassedByLine(triangle, from, to);
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
  boxes.fit(positions, positions);
  boxes.setPatches(nullptr);
  std::vector<OverlappingBoxes> overlaps;
  for (std::size_t leaf = 0; leaf < tree.leafCount(); ++leaf) {
    const auto isLeftOut = [](std::size_t) { return false; };
    tree.forEachLeafFrom(leaf, isLeftOut, [&](std::size_t other) {
      findOverlaps(boxes.triangles(), leaf, boxes.triangles(), other, CommonVertices::Permitted, overlaps);
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
