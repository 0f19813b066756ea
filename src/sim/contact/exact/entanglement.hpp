#pragma once

#include "sim/contact/exact/feature_boxes.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// Marks the vertices of triangles that intersect other triangles of the cloth: an edge of one passes through the
/// other. Contacts and planes between them would keep them intersected.
/// @param tree, boxes of the triangles; they are fitted to the positions  @param entangled result, one per vertex
/// @returns whether there are any
bool findEntangled(const FeatureMesh& mesh, MeshTree& tree, LeafBoxes& boxes, std::span<const Vec3> positions,
                   std::vector<char>& entangled);

}  // namespace drape::sim::contact
