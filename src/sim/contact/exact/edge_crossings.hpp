#pragma once

#include "sim/contact/exact/feature_boxes.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// An edge that passes through a triangle of the same cloth. Two intersecting triangles have at least one.
struct EdgeCrossing {
  int edge = 0;
  int triangle = 0;
};

/// Finds the crossings of a cloth. Edges that touch a triangle without passing through do not count.
/// @param tree, boxes of the triangles; they are fitted to the positions [m]
void findCrossings(const FeatureMesh& mesh, MeshTree& tree, LeafBoxes& boxes, std::span<const Vec3> positions,
                   std::vector<EdgeCrossing>& crossings);

/// Marks the vertices of the features that cross. Contacts and planes between these features would keep them crossed.
/// @param entangled result, one per vertex; empty if nothing crosses
void markEntangled(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings, std::size_t vertexCount,
                   std::vector<char>& entangled);

}  // namespace drape::sim::contact
