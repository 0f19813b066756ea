#pragma once

#include "sim/contact/broad_phase/searchable_mesh.hpp"
#include "sim/contact/closest_features/near_point.hpp"
#include "sim/contact/closest_features/triangle_geometry.hpp"

#include <limits>
#include <span>

namespace drape::sim::contact {

/// A mesh in a pass of contact, in the body's frame. The first pass of a step starts from the cloth at the start of the
/// step. Later passes start from the result of the pass before, which belongs to the end of the step.
struct MeshInStep {
  const SearchableMesh& mesh;
  std::span<const Vec3> startPositions;  ///< of the mesh at the start of the step [m]
  std::span<const Vec3> endPositions;    ///< of the mesh at the end of the step [m]
  bool atEnd = false;                    ///< the cloth's start positions belong to the end of the step

  /// The positions at the time of the cloth's start positions.
  [[nodiscard]] std::span<const Vec3> positions() const { return atEnd ? endPositions : startPositions; }
  /// Whether its vertices move between the cloth's start positions and the end of the step.
  [[nodiscard]] bool moves() const { return !atEnd && mesh.isDeforming(); }

  [[nodiscard]] Corners corners(int triangle) const { return cornersOf(positions(), indices(triangle)); }
  [[nodiscard]] Corners startCorners(int triangle) const { return cornersOf(startPositions, indices(triangle)); }
  [[nodiscard]] Corners endCorners(int triangle) const { return cornersOf(endPositions, indices(triangle)); }

 private:
  [[nodiscard]] const Triangle& indices(int triangle) const { return mesh.shape.triangles[triangle]; }
};

/// The point of a mesh that is closest to a vertex of the cloth.
struct NearestMeshPoint {
  double gap = std::numeric_limits<double>::infinity();  ///< at the start of the pass [m]; infinite: none found
  int triangle = -1;
  Vec3 weights = Vec3::Zero();                                       ///< of the triangle's corners
  Vec3 normal = Vec3::UnitY();                                       ///< towards the cloth
  double squaredDistance = std::numeric_limits<double>::infinity();  ///< the gap as the search compares it [m^2]
};

/// The closest point with its positions at both ends of the step. @param near with a triangle
[[nodiscard]] inline NearPoint pointOf(const MeshInStep& mesh, const NearestMeshPoint& near) {
  return {near.gap, near.normal, pointAt(mesh.startCorners(near.triangle), near.weights),
          pointAt(mesh.endCorners(near.triangle), near.weights)};
}

}  // namespace drape::sim::contact
