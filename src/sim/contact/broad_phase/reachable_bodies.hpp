#pragma once

#include "sim/contact/bodies/body.hpp"
#include "sim/contact/broad_phase/cloth_step.hpp"
#include "sim/contact/broad_phase/mesh_clearance.hpp"
#include "sim/contact/broad_phase/prepared_cloth.hpp"
#include "sim/contact/broad_phase/searchable_mesh.hpp"

#include <map>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// A body that the cloth could reach in a step.
struct ReachableBody {
  const BodyStep* step = nullptr;
  SearchableMesh* mesh = nullptr;  ///< of a box or a mesh; null for other shapes
};

/// The contact offset of vertices from a body [m].
[[nodiscard]] double contactOffsetOf(const BodyStep& step, const ContactParameters& contact);

/// The broad phase of body contact: chooses the bodies that the cloth could reach in a step. It keeps the search
/// structures of meshes, and the clearances between them and the cloth.
///
/// A body is out of reach if its bounding box, inflated by two contact offsets, does not overlap that of the cloth's
/// motion in its frame. A rigid mesh is also out of reach if no cluster of the cloth comes near its surface
/// (MeshClearance) and no piece of the cloth is inside it.
class ReachableBodies {
 public:
  /// Whether cloth that moves from one box into another could come near any of the bodies, by the bounding boxes only.
  [[nodiscard]] bool couldReachAny(const ContactParameters& contact, const std::vector<BodyStep>& bodies,
                                   const Eigen::AlignedBox3d& start, const Eigen::AlignedBox3d& end);

  /// Whether cloth that moves from `start` to `end` comes so near to a body that the step needs contact substeps. The
  /// result depends on these arguments only, not on earlier calls.
  /// @param spread possible distance of the final positions from `end` [m]
  [[nodiscard]] bool isNearAny(const ClothModel& model, const PreparedCloth& cloth, const ContactParameters& contact,
                               const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start,
                               const std::vector<Vec3>& end, double spread);

  /// The bodies that the cloth could reach on its way into the box `ends`, except those in `known`.
  /// @param positions present positions, corrected by contact with the known bodies [m]
  [[nodiscard]] std::vector<ReachableBody> find(const ClothStep& step, const PreparedCloth& cloth,
                                                const std::vector<BodyStep>& bodies, const std::vector<Vec3>& positions,
                                                const Eigen::AlignedBox3d& ends,
                                                const std::vector<const BodyStep*>& known);

 private:
  struct Mesh {
    explicit Mesh(MeshShape shape) : searchable(std::move(shape)) {}
    SearchableMesh searchable;
    MeshClearance clearance;
    std::size_t nearCluster = 0;  // cluster of the cloth that was near the mesh in the last isNear
  };

  Mesh* meshOf(const BodyStep& body);
  ClothMotion motionIn(const BodyStep& body, const ClothModel& model, const PreparedCloth& cloth,
                       const std::vector<Vec3>& start, const std::vector<Vec3>& end);
  ClothMotion clusterMotionIn(const BodyStep& body, const ClothModel& model, const PreparedCloth& cloth,
                              std::size_t cluster, const std::vector<Vec3>& start, const std::vector<Vec3>& end);
  bool isNear(const BodyStep& body, Mesh& mesh, const ClothModel& model, const PreparedCloth& cloth,
              const std::vector<Vec3>& start, const std::vector<Vec3>& end, double far);
  bool isKnownClearOf(const ClothStep& step, const PreparedCloth& cloth, const BodyStep& body, Mesh& mesh,
                      const std::vector<Vec3>& positions);

  std::map<const Body*, Mesh> meshes_;  // never iterated over, since the order of addresses varies
  std::vector<Vec3> localStart_;        // used by motionIn [m]
  std::vector<Vec3> localEnd_;          // likewise
};

}  // namespace drape::sim::contact
