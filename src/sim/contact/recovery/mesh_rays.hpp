#pragma once

#include "sim/contact/closest_features/mesh_in_step.hpp"

#include <vector>

namespace drape::sim::contact {

/// A point where a ray passes through a mesh.
struct Crossing {
  double distance = 0.0;  ///< from the origin of the ray [m]
  int triangle = -1;
  Vec3 weights = Vec3::Zero();  ///< of the triangle's corners
  bool outwards = false;        ///< the ray passes from the back of the triangle to its front
};

/// Finds the crossings of the ray from a point along a unit vector with a mesh at the start of the pass, in the order
/// of the mesh's tree. A ray through an edge or a corner crosses exactly one of the adjacent triangles, or as many
/// outwards as inwards: it counts as displaced by an infinitesimal distance (simulation of simplicity, Edelsbrunner and
/// Muecke 1990), and neighbouring triangles use the same rounded numbers for their common side.
void crossingsAlong(const MeshInStep& mesh, const Vec3& from, const Vec3& direction, std::vector<Crossing>& crossings);

/// The number of outward crossings minus that of inward ones: for a closed mesh the winding number at the ray's origin.
[[nodiscard]] int windingOf(const std::vector<Crossing>& crossings);

}  // namespace drape::sim::contact
