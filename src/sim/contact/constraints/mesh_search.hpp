#pragma once

#include "sim/contact/broad_phase/cloth_clusters.hpp"
#include "sim/contact/closest_features/mesh_in_step.hpp"
#include "sim/contact/closest_features/nearest_search.hpp"
#include "sim/contact/constraints/sharp_feature_search.hpp"
#include "sim/contact/separating_planes/plane_search.hpp"
#include "sim/workers.hpp"

#include <vector>

namespace drape {

/// Looks for what is near a box or a mesh in one step: where vertices, edges and triangles of the cloth are about to
/// come nearer than they may, and planes between every triangle and what of the body it could meet.
///
/// Clusters of the cloth find the body's leaves near them. Vertices look for their nearest point as far as they are
/// about to go; but edges and faces are looked at when it is known where contacts of vertices let the cloth go, and
/// planes are looked for when all contacts are known. Then it mostly goes not far.
///
/// What was found serves while a cluster hardly moves in the body's frame, where the mesh does not move in itself.
/// Lists of leaves hold a little more than is near; whoever reads them takes what is near. Distances are known with
/// the way that was gone since then: a triangle that by them goes nowhere near the mesh needs no plane, unless a plane
/// of another one moves its vertices; then it is asked for. So results do not depend on when something was found.
class MeshSearch {
 public:
  /// A pass begins: what pierced the mesh is forgotten.
  /// @param mesh to be searched, by address  @param model tells cloths apart
  void begin(const SearchableMesh& mesh, std::uint64_t model);

  /// Adds contacts of the cloth's vertices to `candidates`.
  /// @param cloth with room for all the way to its target
  void findVertexContacts(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                          const ClothClusters& clusters, Workers& workers, int threads, Candidates& candidates);

  /// Adds contacts of its edges and faces, after findVertexContacts, in an order that does not depend on the threads.
  /// @param cloth its target is where contacts of its vertices alone let it go
  void findSharpFeatureContacts(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                                const ClothClusters& clusters, Workers& workers, int threads, Candidates& candidates);

  /// Adds planes to `candidates`, after both.
  /// @param cloth its target is where contacts let it go, with room for that
  /// @param ways from bases to targets [m]
  /// @return true when some of the cloth pierces the mesh of which findVertexContacts did not know: it should be asked
  /// again
  bool findPlanes(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                  const ClothClusters& clusters, std::span<const double> displacements, Workers& workers, int threads,
                  Candidates& candidates);

  /// Whether some of the cloth is known to pierce the mesh in this pass, and for each triangle of it whether it does.
  [[nodiscard]] bool pierced() const { return !piercings_.empty(); }
  [[nodiscard]] std::vector<bool> pierces(std::size_t triangles) const;

  /// Has findPlanes look at all triangles with a vertex that was moved from its target.
  /// @return true when it did without one of these before
  bool requestPlanesAround(std::span<const Triangle> triangles, const std::vector<bool>& moved);
  /// Has it look at all triangles.
  void requestAllPlanes() { requested_.assign(requested_.size(), 1); }

  /// How far the mesh's nearest point to a vertex of the cloth moves in the body's frame [m]; zero where none is near.
  [[nodiscard]] Vec3 bodyDisplacementAt(const MeshInStep& mesh, int vertex) const;

 private:
  struct NearbyLeaves {
    Eigen::AlignedBox3d covered;  // all leaves that meet it are listed
    std::vector<int> leaves;
    BoxList boxes;
    std::vector<Vec3> reference;    // its vertices when distances were found [m]
    std::vector<double> distances;  // between its triangles and the mesh then, at least [m]
    double moved = 0.0;             // since then, at most [m]; infinite: distances have to be found

    void list(const MeshTree& tree, const Eigen::AlignedBox3d& box);
  };
  class ClusterSearch;
  void searchTriangles(const ClothInBody& cloth, std::span<const int> triangles, NearbyLeaves& nearby,
                       const ContactOffsets& offsets, SharpFeatureSearch& sharp);
  void markPenetrating(const ClothInBody& cloth);
  void addVertexContacts(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                         Candidates& candidates) const;
  void addRecoveryContacts(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                           Candidates& candidates) const;
  void addContactAcrossTriangle(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                                std::size_t first, std::size_t last, Candidates& candidates) const;
  void addContactToFront(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                         const Piercing& piercing, Candidates& candidates) const;
  void countOverlaps(const ClothInBody& cloth, Candidates& candidates) const;
  const NearbyLeaves& leavesWithinBound(const ConstraintBuilder& builder, const MeshInStep& mesh,
                                        const ClothInBody& cloth, const ClothClusters& clusters, std::size_t cluster,
                                        NearbyLeaves& wider) const;
  void findPlanesOf(int triangle, const MeshInStep& mesh, const NearbyLeaves& nearby, PlaneSearch& planes,
                    Candidates& candidates) const;
  bool keepKnownPiercings(const MeshInStep& mesh, int triangle, PlaneSearch& planes) const;
  void addPlanesAtOverlap(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                          Candidates& candidates) const;

  const SearchableMesh* mesh_ = nullptr;    // that the lists are for ...
  std::uint64_t model_ = 0;                 // ... and the cloth
  std::vector<NearbyLeaves> nearby_;        // of each cluster
  std::vector<NearestMeshPoint> nearest_;   // to each vertex
  std::vector<NearbyTriangles> near_;       // the same: where to look for it
  std::vector<double> distances_;           // of each triangle to the mesh, at least, at the base [m]
  std::vector<Vec3> outwards_;              // of each triangle, where its distance was found: where to look first
  std::vector<char> skipped_;               // for each triangle whether no plane was looked for ...
  std::vector<char> requested_;             // ... and whether one has to be
  std::vector<Piercing> piercings_;         // in the order of the cloth's triangles as clusters have them
  bool piercingsKnown_ = false;             // of this pass: what pierces at the base goes on to
  std::vector<std::size_t> firstPiercing_;  // of each triangle of the cloth
  std::vector<bool> pierces_;               // for each triangle of the cloth
  std::vector<bool> penetrating_;           // the same, or a vertex of it is inside
  std::vector<bool> besidePenetrating_;     // for each vertex whether a triangle of it is caught
};

}  // namespace drape
