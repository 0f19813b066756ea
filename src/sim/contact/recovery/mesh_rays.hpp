#pragma once

#include "sim/contact/closest_features/mesh_in_step.hpp"

#include <vector>

namespace drape {

/// Where a ray passes through a mesh.
struct Crossing {
  double distance = 0.0;  ///< from where the ray begins [m]
  int triangle = -1;
  Vec3 weights = Vec3::Zero();  ///< of the triangle's corners
  bool outwards = false;        ///< it goes from the triangle's back to its front
};

/// Finds where the ray from a point along a unit vector passes through a mesh at the cloth's base, in the order of the
/// mesh's tree. A ray that meets an edge or a corner passes through exactly one of the triangles around it, or through
/// as many outwards as inwards: it is looked at as if moved aside by less than any number (simulation of simplicity,
/// Edelsbrunner and Muecke 1990), and the sides of neighbouring triangles are judged by the same rounded numbers.
void crossingsAlong(const MeshInStep& mesh, const Vec3& from, const Vec3& direction, std::vector<Crossing>& crossings);

/// How often the ray leaves less how often it enters: of a closed mesh its winding number around the point.
[[nodiscard]] int windingOf(const std::vector<Crossing>& crossings);

}  // namespace drape
