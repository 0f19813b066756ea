#pragma once

#include "sim/contact/closest_features/mesh_in_step.hpp"

#include <array>
#include <span>
#include <vector>

namespace drape {

/// What a search for a vertex's nearest point leaves behind: how far everything is, and the triangles that can have it
/// while the vertex stays near.
struct NearbyTriangles {
  static constexpr std::size_t capacity = 16;

  Vec3 at = Vec3::Zero();     ///< where the vertex was [m]
  double validRadius = -1.0;  ///< how far from there it may be [m]; negative: there is nothing to be had here
  double clearRadius = -1.0;  ///< how far from there the mesh was, at least [m]
  std::array<int, capacity> triangles{};
  std::array<float, capacity> toBox{};  ///< from there to the boxes around them, at least [m]
  std::size_t count = 0;
};

/// Finds the point of a mesh that is nearest to a point of the cloth, at its base. Of triangles that are as near, bit
/// by bit, it takes the first: so the result does not depend on where and in what order was looked.
class NearestSearch {
 public:
  explicit NearestSearch(const MeshInStep& mesh) : mesh_(mesh) {}

  /// Looks into some leaves of the mesh's tree.
  /// @param boxes theirs  @param radius nothing farther counts [m]
  /// @param within how far the point may move from there for what is remembered of this search to serve [m]
  [[nodiscard]] NearestMeshPoint among(const std::vector<int>& leaves, const BoxList& boxes, const Vec3& point,
                                       double radius, double within = 0.0);

  /// Remembers after `among` what can be nearest while the point stays near.
  /// @param beyond how far it is to what was not among the leaves, at least [m]
  void remember(const Vec3& point, double within, double beyond, NearbyTriangles& memory) const;

  /// The same as `among`, by what is remembered of a place that is at most `moved` [m] away, which serves.
  [[nodiscard]] NearestMeshPoint amongRemembered(const NearbyTriangles& memory, const Vec3& point, double radius,
                                                 double moved);

  /// Looks into the whole mesh.
  [[nodiscard]] NearestMeshPoint anywhere(const Vec3& point, double radius);

 private:
  void testTriangle(int triangle, const Vec3& point);
  [[nodiscard]] int triangleAt(std::size_t box) const;
  [[nodiscard]] NearestMeshPoint result(const Vec3& point);

  const MeshInStep& mesh_;
  std::vector<double> toLeaf_;      // of all that were given [m^2]
  std::vector<std::int32_t> near_;  // leaves
  std::vector<double> toBox_;       // of their triangles [m^2]
  NearestMeshPoint best_;
  double minSquaredDistance_ = 0.0;  // [m^2]
};

}  // namespace drape
