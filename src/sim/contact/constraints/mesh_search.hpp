#pragma once

#include "sim/contact/broad_phase/cloth_clusters.hpp"
#include "sim/contact/closest_features/mesh_in_step.hpp"
#include "sim/contact/closest_features/nearest_search.hpp"
#include "sim/contact/constraints/sharp_feature_search.hpp"
#include "sim/contact/separating_planes/plane_search.hpp"
#include "sim/model/workers.hpp"

#include <vector>

namespace drape::sim::contact {

/// Finds contacts and separating planes of a cloth with a box or a mesh in one pass, in three steps:
///
/// 1. `findVertexContacts`: each cluster of the cloth lists the leaves of the mesh's tree near it. Each vertex finds
///    the closest point of the mesh within its displacement bound.
/// 2. `findSharpFeatureContacts`, after the contacts of vertices have been solved: contacts of edges and faces.
/// 3. `findPlanes`, after all contacts have been solved: separating planes. The displacements are then small, so that
///    most triangles need none.
///
/// On rigid meshes results are cached while a cluster hardly moves in the body's frame. Cached lists of leaves cover a
/// larger region and are filtered when used. Cached distances are reduced by the displacement since they were measured,
/// so they are lower bounds. A triangle that stays clear of the mesh by these bounds gets no plane, unless a plane of
/// another triangle moves its vertices; then its planes are requested. On deforming meshes only the search for a list
/// of substep contacts is cached, for the next search from the same positions. So results do not depend on when
/// something was cached.
class MeshSearch {
 public:
  /// Starts a pass: forgets which triangles pierced the mesh, and cached data of another mesh or cloth.
  /// @param mesh identified by its address  @param model a number that identifies the cloth
  void begin(const SearchableMesh& mesh, std::uint64_t model);

  /// Adds contacts of the cloth's vertices to `candidates`.
  /// @param cloth with displacement bounds that include the predicted positions
  void findVertexContacts(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                          const ClothClusters& clusters, Workers& workers, int threads, Candidates& candidates);

  /// Adds contacts of its edges and faces, after findVertexContacts, in an order that does not depend on the threads.
  /// @param cloth its predicted positions are those with contacts of vertices only
  void findSharpFeatureContacts(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                                const ClothClusters& clusters, Workers& workers, int threads, Candidates& candidates);

  /// Adds separating planes to `candidates`, after the two functions above.
  /// @param cloth its predicted positions are those with all contacts, within the displacement bounds
  /// @param displacements of each vertex from start to predicted [m]
  /// @return true if triangles pierce the mesh that findVertexContacts did not know of; the search must be repeated
  bool findPlanes(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                  const ClothClusters& clusters, std::span<const double> displacements, Workers& workers, int threads,
                  Candidates& candidates);

  /// Whether some of the cloth is known to pierce the mesh in this pass.
  [[nodiscard]] bool pierced() const { return !piercings_.empty(); }
  /// The same for each triangle of the cloth. @param triangles their number
  [[nodiscard]] std::vector<bool> pierces(std::size_t triangles) const;

  /// Requests planes for all triangles with a moved vertex that findPlanes has skipped.
  /// @param moved per vertex, whether planes moved it from its solved position
  /// @return true if findPlanes had skipped such a triangle
  bool requestPlanesAround(std::span<const Triangle> triangles, const std::vector<bool>& moved);
  /// Requests planes for all triangles.
  void requestAllPlanes() { requested_.assign(requested_.size(), 1); }

  /// Whether a vertex is behind the face of a closed mesh that is closest to it, so that it may be inside. After
  /// findVertexContacts.
  [[nodiscard]] bool isBehindFace(const MeshInStep& mesh, int vertex) const;

  /// Displacement over the step of the closest point to a vertex, in the body's frame [m]; zero if none is near.
  [[nodiscard]] Vec3 bodyDisplacementAt(const MeshInStep& mesh, int vertex) const;

 private:
  struct NearbyLeaves {
    Eigen::AlignedBox3d covered;  // all leaves that intersect this box are listed
    std::vector<int> leaves;
    BoxList boxes;
    std::vector<Vec3> reference;    // positions of the cluster's vertices when distances were computed [m]
    std::vector<double> distances;  // lower bounds of the distances of its triangles to the mesh there [m]
    double moved = 0.0;             // maximum displacement from there [m]; infinite: distances are unknown

    void list(const MeshTree& tree, const Eigen::AlignedBox3d& box);
  };
  class ClusterSearch;
  [[nodiscard]] bool isSearched(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth);
  void useKnownDistances(std::span<const int> triangles, NearbyLeaves& nearby);
  void searchTriangles(const MeshInStep& mesh, const ClothInBody& cloth, std::span<const int> triangles,
                       NearbyLeaves& nearby, const ContactOffsets& offsets, SharpFeatureSearch& sharp);
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

  const SearchableMesh* mesh_ = nullptr;   // mesh of the cached data
  std::uint64_t model_ = 0;                // cloth of the cached data
  std::vector<NearbyLeaves> nearby_;       // per cluster
  std::vector<NearestMeshPoint> nearest_;  // per vertex
  std::vector<NearbyTriangles> near_;      // per vertex: cached triangles for `nearest_`
  std::vector<double> distances_;          // per triangle: lower bound to the mesh at the start of the pass [m]
  std::vector<Vec3> searched_;             // start positions of the last search of the vertices [m]
  double searchedOffset_ = 0.0;            // contact offset in that search [m]
  std::uint64_t searchedVersion_ = 0;      // version of the mesh in that search
  std::vector<double> searchedRadius_;     // per vertex: the distance up to which it searched [m]
  bool samePositions_ = false;             // the present search starts from `searched_`
  std::vector<double> featureGaps_;       // per triangle: lower bound of the distance to features of the mesh there [m]
  std::vector<NearbyFeatures> features_;  // per triangle: cached features of the mesh
  std::vector<Vec3> outwards_;       // per triangle: direction of its widest gap, with which the next search starts
  std::vector<char> skipped_;        // per triangle: no planes were searched
  std::vector<char> requested_;      // per triangle: planes must be searched
  std::vector<Piercing> piercings_;  // in the order of triangles by cluster
  bool piercingsKnown_ = false;      // in this pass; they stay the same over the pass
  std::vector<std::size_t> firstPiercing_;  // per triangle: index into piercings_
  std::vector<bool> pierces_;               // per triangle: it pierces the mesh
  std::vector<bool> penetrating_;           // per triangle: it pierces the mesh, or a vertex is inside
  std::vector<bool> besidePenetrating_;     // per vertex: a triangle of it is penetrating
};

}  // namespace drape::sim::contact
