#pragma once

#include "sim/contact/constraints/constraint_builder.hpp"
#include "sim/contact/broad_phase/searchable_mesh.hpp"

#include <limits>
#include <span>

namespace drape {

/// A mesh in a step, as a pass of the search sees it, in the body's frame.
struct MeshInStep {
  const SearchableMesh& mesh;
  std::span<const Vec3> before;  ///< when the step begins [m]
  std::span<const Vec3> after;   ///< when it ends [m]
  bool settled = false;          ///< the cloth's base is at the end of the step, and is judged against the mesh there

  [[nodiscard]] std::span<const Vec3> atBase() const { return settled ? after : before; }
  /// Whether it is elsewhere at the end of the step than at the cloth's base.
  [[nodiscard]] bool moves() const { return !settled && mesh.movesInItself(); }

  [[nodiscard]] Corners base(int triangle) const { return cornersOf(atBase(), indices(triangle)); }
  [[nodiscard]] Corners start(int triangle) const { return cornersOf(before, indices(triangle)); }
  [[nodiscard]] Corners end(int triangle) const { return cornersOf(after, indices(triangle)); }

 private:
  [[nodiscard]] const Triangle& indices(int triangle) const {
    return mesh.shape.triangles[static_cast<std::size_t>(triangle)];
  }
};

/// The point of a mesh that is nearest to a vertex of the cloth.
struct NearVertex {
  double gap = std::numeric_limits<double>::infinity();  ///< at the base [m]; infinite: there is none within reach
  int triangle = -1;
  Vec3 weights = Vec3::Zero();  ///< of the triangle's corners
  Vec3 normal = Vec3::UnitY();  ///< towards the cloth
};

[[nodiscard]] inline NearPoint pointOf(const MeshInStep& mesh, const NearVertex& near) {
  return {near.gap, near.normal, pointAt(mesh.start(near.triangle), near.weights),
          pointAt(mesh.end(near.triangle), near.weights)};
}

/// How far a triangle reaches along a direction [m].
[[nodiscard]] inline double lowestAlong(const Vec3& direction, const Corners& corners) {
  return std::min({direction.dot(corners[0]), direction.dot(corners[1]), direction.dot(corners[2])});
}
[[nodiscard]] inline double highestAlong(const Vec3& direction, const Corners& corners) {
  return std::max({direction.dot(corners[0]), direction.dot(corners[1]), direction.dot(corners[2])});
}

[[nodiscard]] inline Eigen::AlignedBox3d boxAround(const Corners& corners) {
  return {corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]), corners[0].cwiseMax(corners[1]).cwiseMax(corners[2])};
}

[[nodiscard]] inline Eigen::AlignedBox3d inflated(const Eigen::AlignedBox3d& box, double by) {
  return {(box.min().array() - by).matrix(), (box.max().array() + by).matrix()};
}

}  // namespace drape
