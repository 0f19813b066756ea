#pragma once

#include "sim/cloth_model.hpp"
#include "sim/contact/broad_phase/cloth_clusters.hpp"
#include "sim/contact/broad_phase/searchable_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace drape {

/// The way of a cloth over a step, in a body's frame.
struct ClothMotion {
  const ClothModel& model;
  const ClothClusters& clusters;
  std::span<const Vec3> start;  ///< one place a vertex [m]
  std::span<const Vec3> end;    ///< likewise; vertices go straight [m]
};

/// Tells cheaply that a cloth does not come near a mesh that keeps its shape, so that contact need not look at it. A
/// skirt around a stand, or a flag beside its pole, is within the mesh's box all the time and seldom near its surface.
///
/// Each cluster of triangles remembers where it was when its distance was measured, and how far it may go from there.
class MeshClearance {
 public:
  /// Whether any triangle could come nearer to the mesh's surface than `keep` [m]. True also where that is not known.
  /// Triangles whose corners are all pinned do not count.
  /// @param models a number that changes when the model does
  [[nodiscard]] bool couldMeet(const SearchableMesh& mesh, const ClothMotion& motion, double distance,
                               std::uint64_t models);

 private:
  struct Known {
    std::vector<Vec3> reference;  // where the cluster's vertices were [m]
    double slack = -1.0;          // how far each may be from there [m]
  };

  [[nodiscard]] double slackOf(const SearchableMesh& mesh, const ClothMotion& motion, std::size_t cluster,
                               double distance);

  std::vector<Known> known_;  // one a cluster
  std::vector<std::int32_t> leaves_;
  std::vector<std::int32_t> leaf_;
  std::vector<Extent> extents_;
  std::uint64_t models_ = 0;
  double distance_ = 0.0;
};

/// Whether a vertex that is not pinned comes within the distance `far` [m] of a mesh's surface. The number
/// of rounds of a step follows from it, so the answer depends on nothing but the way.
[[nodiscard]] bool freeClothIsNear(const SearchableMesh& mesh, const ClothMotion& motion, double far);

}  // namespace drape
