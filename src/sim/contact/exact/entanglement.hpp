#pragma once

#include "sim/contact/broad_phase/mesh_tree.hpp"
#include "sim/contact/exact/feature_mesh.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// Marks the vertices of triangles that intersect other triangles of the cloth: an edge of one passes through the
/// other. Contacts and planes between them would keep them intersected.
/// @param tree of the triangles; it is fitted to the positions  @param entangled result, one per vertex
/// @returns whether there are any
bool findEntangled(const FeatureMesh& mesh, MeshTree& tree, std::span<const Vec3> positions,
                   std::vector<char>& entangled);

}  // namespace drape::sim::contact
