#pragma once

#include "intersection/intersections.hpp"
#include "sim/model/cloth_model.hpp"

#include <span>
#include <vector>

namespace drape::sim {

/// Moves layers of a cloth apart that lie in one plane, by less than its thickness. In one plane nothing tells their
/// order, so that self-collision cannot separate them. Their order becomes that of their normals, and of the connected
/// parts of the mesh.
/// @param pairs two intersecting triangles each; those in different planes are ignored
/// @param thickness of the cloth [m]
/// @param positions of all vertices [m]; changed
void openFlatLayers(const ClothModel& model, std::span<const intersection::TrianglePair> pairs, double thickness,
                    std::vector<Vec3>& positions);

}  // namespace drape::sim
