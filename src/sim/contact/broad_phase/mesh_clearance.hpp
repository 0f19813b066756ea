#pragma once

#include "sim/contact/broad_phase/cloth_clusters.hpp"
#include "sim/contact/broad_phase/searchable_mesh.hpp"
#include "sim/model/cloth_model.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// The motion of a cloth over a step, in a body's frame. The vertices move on straight lines.
struct ClothMotion {
  const ClothModel& model;
  const ClothClusters& clusters;
  std::span<const Vec3> start;  ///< positions of the vertices at the start [m]
  std::span<const Vec3> end;    ///< and at the end [m]
};

/// Broad phase for rigid meshes: decides at low cost that a cloth does not come near the surface of a mesh. A skirt
/// around a stand, or a flag beside its pole, is always inside the bounding box of the mesh, but rarely near its
/// surface.
///
/// Each cluster of triangles caches the positions at which its distance was measured, and a slack: the displacement
/// from there up to which it stays clear of the mesh. While all vertices of a cluster are within the slack at the start
/// and at the end, its distance is not measured again.
class MeshClearance {
 public:
  /// Whether any triangle could come closer to the mesh's surface than `distance` [m]. False is certain. Triangles with
  /// three pinned corners do not count.
  /// @param models a number that identifies the model of the cloth
  [[nodiscard]] bool couldMeet(const SearchableMesh& mesh, const ClothMotion& motion, double distance,
                               std::uint64_t models);

  /// The same for one cluster. Reads the motion of its vertices only.
  [[nodiscard]] bool couldMeet(const SearchableMesh& mesh, const ClothMotion& motion, double distance,
                               std::uint64_t models, std::size_t cluster);

  /// The cluster for which the result was true last.
  [[nodiscard]] std::size_t lastCluster() const { return lastCluster_; }

 private:
  struct Known {
    std::vector<Vec3> reference;  // positions of the cluster's vertices [m]
    double slack = -1.0;          // permitted displacement of each from there [m]
  };

  void prepare(const ClothMotion& motion, double distance, std::uint64_t models);
  [[nodiscard]] bool clusterCouldMeet(const SearchableMesh& mesh, const ClothMotion& motion, std::size_t cluster);
  [[nodiscard]] double slackOf(const SearchableMesh& mesh, const ClothMotion& motion, std::size_t cluster,
                               double distance);

  std::vector<Known> known_;          // per cluster
  std::vector<std::int32_t> leaves_;  // scratch of slackOf, as the next two
  std::vector<std::int32_t> leaf_;
  std::vector<Extent> extents_;
  std::uint64_t models_ = 0;     // model of `known_`
  double distance_ = 0.0;        // distance of `known_` [m]
  std::size_t lastCluster_ = 0;  // see lastCluster()
};

/// Whether a vertex of a cluster that is not pinned could come within the distance `far` [m] of a mesh's surface. The
/// number of contact substeps depends on the result. So it depends on the motion only, not on cached data.
[[nodiscard]] bool freeClothIsNear(const SearchableMesh& mesh, const ClothMotion& motion, double far,
                                   std::size_t cluster);

/// The same for all clusters of the cloth.
/// @param nearCluster set to a cluster that is near, if the result is true
[[nodiscard]] bool anyFreeClothIsNear(const SearchableMesh& mesh, const ClothMotion& motion, double far,
                                      std::size_t& nearCluster);

}  // namespace drape::sim::contact
