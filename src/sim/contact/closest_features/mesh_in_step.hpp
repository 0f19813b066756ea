#pragma once

#include "sim/contact/broad_phase/searchable_mesh.hpp"
#include "sim/contact/closest_features/near_point.hpp"
#include "sim/contact/closest_features/triangle_geometry.hpp"

#include <limits>
#include <span>

namespace drape {

/// A mesh in a step, as a pass of the search sees it, in the body's frame.
struct MeshInStep {
  const SearchableMesh& mesh;
  std::span<const Vec3> startPositions;  ///< when the step begins [m]
  std::span<const Vec3> endPositions;    ///< when it ends [m]
  bool atEnd = false;  ///< the cloth's base is at the end of the step, and is judged against the mesh there

  [[nodiscard]] std::span<const Vec3> positions() const { return atEnd ? endPositions : startPositions; }
  /// Whether it is elsewhere at the end of the step than at the cloth's base.
  [[nodiscard]] bool moves() const { return !atEnd && mesh.isDeforming(); }

  [[nodiscard]] Corners corners(int triangle) const { return cornersOf(positions(), indices(triangle)); }
  [[nodiscard]] Corners startCorners(int triangle) const { return cornersOf(startPositions, indices(triangle)); }
  [[nodiscard]] Corners endCorners(int triangle) const { return cornersOf(endPositions, indices(triangle)); }

 private:
  [[nodiscard]] const Triangle& indices(int triangle) const {
    return mesh.shape.triangles[static_cast<std::size_t>(triangle)];
  }
};

/// The point of a mesh that is nearest to a vertex of the cloth.
struct NearestMeshPoint {
  double gap = std::numeric_limits<double>::infinity();  ///< at the base [m]; infinite: there is none within reach
  int triangle = -1;
  Vec3 weights = Vec3::Zero();  ///< of the triangle's corners
  Vec3 normal = Vec3::UnitY();  ///< towards the cloth
};

[[nodiscard]] inline NearPoint pointOf(const MeshInStep& mesh, const NearestMeshPoint& near) {
  return {near.gap, near.normal, pointAt(mesh.startCorners(near.triangle), near.weights),
          pointAt(mesh.endCorners(near.triangle), near.weights)};
}

}  // namespace drape
