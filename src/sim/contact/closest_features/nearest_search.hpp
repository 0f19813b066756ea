#pragma once

#include "sim/contact/closest_features/mesh_in_step.hpp"

#include <array>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// Cached result of a search for the closest point to a vertex: a lower bound of the distance, and the triangles that
/// can contain the closest point while the vertex stays near.
struct NearbyTriangles {
  static constexpr std::size_t capacity = 16;

  Vec3 at = Vec3::Zero();     ///< position of the vertex in the search [m]
  double validRadius = -1.0;  ///< maximum displacement for which the triangles are valid [m]; negative: they are not
  double clearRadius = -1.0;  ///< lower bound of the distance of `at` to the mesh [m]
  std::array<int, capacity> triangles{};
  std::array<float, capacity> distances{};  ///< lower bounds of the distances to them [m]
  std::size_t count = 0;
};

/// Finds the point of a mesh that is closest to a point of the cloth at the start of the pass. If triangles are at
/// exactly the same distance it takes the first one, so that the result does not depend on the order of the search. All
/// functions return a point without a triangle if nothing is closer than `radius`.
class NearestSearch {
 public:
  explicit NearestSearch(const MeshInStep& mesh) : mesh_(mesh) {}

  /// The closest point in some leaves of the mesh's tree.
  /// @param boxes of these leaves  @param radius maximum distance [m]
  /// @param within displacement of the point up to which the cached result must be valid [m]
  [[nodiscard]] NearestMeshPoint among(const std::vector<int>& leaves, const BoxList& boxes, const Vec3& point,
                                       double radius, double within = 0.0);

  /// Caches the triangles that can be closest while the point stays near. Call it after `among`.
  /// @param beyond lower bound of the distance to all other leaves [m]
  void remember(const Vec3& point, double within, double beyond, NearbyTriangles& memory) const;

  /// The same as `among`, from a cached result that is valid for `point`.
  /// @param moved distance of `point` from the position of the cached search [m]
  [[nodiscard]] NearestMeshPoint amongRemembered(const NearbyTriangles& memory, const Vec3& point, double radius,
                                                 double moved);

  /// The closest point of the whole mesh.
  [[nodiscard]] NearestMeshPoint anywhere(const Vec3& point, double radius);

 private:
  void testTriangle(int triangle, const Vec3& point);
  [[nodiscard]] double squaredDistanceTo(int triangle, const Vec3& point) const;
  [[nodiscard]] int triangleAt(std::size_t box) const;
  [[nodiscard]] NearestMeshPoint result(const Vec3& point);

  const MeshInStep& mesh_;
  std::vector<double> toLeaf_;      // squared distances to the boxes of all given leaves [m^2]
  std::vector<std::int32_t> near_;  // leaves within the radius
  std::vector<double> toBox_;       // squared distances to the boxes of their triangles [m^2]
  NearestMeshPoint best_;
  double minSquaredDistance_ = 0.0;  // [m^2]
};

}  // namespace drape::sim::contact
