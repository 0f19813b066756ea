#pragma once

#include "sim/contact/broad_phase/mesh_clearance.hpp"
#include "sim/contact/constraints/mesh_search.hpp"
#include "sim/contact/constraints/primitive_search.hpp"
#include "sim/contact/contact_parameters.hpp"
#include "sim/contact/contact_report.hpp"
#include "sim/contact/recovery/overlap.hpp"
#include "sim/contact/separating_planes/separating_plane_filter.hpp"
#include "sim/contact/solve/contact_solver.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/forces/substep_contact.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/model_cache.hpp"
#include "sim/model/workers.hpp"

#include <map>
#include <memory>
#include <vector>

namespace drape::sim::contact {

/// Contact of a cloth with bodies (docs/theory/contact.md).
///
/// Each step is considered in the frame of each body, in which a rigid body stands still. A pass has these stages:
///
/// 1. Transform the cloth into the frames of the bodies, and bound the displacement of each vertex.
/// 2. Find the cloth that is inside bodies, and its exits.
/// 3. Find contacts of vertices, and solve for impulses with friction. On meshes, find contacts of edges and faces at
///    the solved positions, and solve again.
/// 4. Find planes that separate each triangle of the cloth from every part of the bodies that it could reach.
/// 5. Project the vertices onto the permitted side of the planes of their triangles, so that nothing intersects.
///
/// If this moved the cloth far, the constraints no longer fit the bodies. Then another pass starts from the result. The
/// velocities are corrected after the last pass.
class BodyContact {
 public:
  /// Corrects positions and velocities of `state`, which a solver predicted from `start`.
  /// @param points the active contacts are appended
  void resolve(const ClothModel& model, const CommonParameters& parameters, const ContactParameters& contact,
               const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start, ClothState& state,
               ContactReport& report, std::vector<ContactPoint>& points);

  /// Finds the contacts that can become active in a step, for solvers that resolve contacts in their substeps. Vertices
  /// inside bodies get none, since they must leave.
  /// @param start positions at the start of the step [m]  @param ahead the same, extrapolated by the velocities [m]
  /// @param found the contacts are appended
  void findSubstepContacts(const ClothModel& model, const CommonParameters& parameters,
                           const ContactParameters& contact, const std::vector<BodyStep>& bodies,
                           const std::vector<Vec3>& start, const std::vector<Vec3>& ahead,
                           std::vector<SubstepContact>& found);

  /// Reports contacts of vertices that acted in the substeps, unless `resolve` reported these vertices.
  void reportSubstepContacts(const std::vector<SubstepContact>& contacts, const ClothState& state,
                             ContactReport& report, std::vector<ContactPoint>& points) const;

  /// The separating planes of the last pass of `resolve`.
  [[nodiscard]] std::span<const SeparatingPlane> planes() const {
    return nearCount_ > 0 ? std::span<const SeparatingPlane>(candidates_.planes) : std::span<const SeparatingPlane>();
  }
  /// Moves positions at the start of the step along with the bodies whose planes limit their vertices in `resolve` [m].
  void carryAlong(std::vector<Vec3>& positions) const;

  /// Whether cloth that moves from one box into another could come near any of the bodies.
  [[nodiscard]] bool couldReachAnyBody(const ContactParameters& contact, const std::vector<BodyStep>& bodies,
                                       const Eigen::AlignedBox3d& start, const Eigen::AlignedBox3d& end);

  /// Whether cloth that moves from `start` to `end` comes so near to a body that the step needs contact substeps.
  /// The result depends on these arguments only, not on earlier calls.
  /// @param spread possible distance of the final positions from `end` [m]
  [[nodiscard]] bool isNearAnyBody(const ClothModel& model, const ContactParameters& contact,
                                   const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start,
                                   const std::vector<Vec3>& end, double spread);

 private:
  struct Cloth {
    const ClothModel& model;
    const CommonParameters& parameters;
    const ContactParameters& contact;
    const std::vector<Vec3>& start;      // at the start of the step [m]
    const std::vector<Vec3>& predicted;  // at its end, without contact [m]
  };
  struct NearBody {
    const BodyStep* step = nullptr;
    SearchableMesh* mesh = nullptr;  // of a box or a mesh
    ContactOffsets offsets;
    std::vector<Vec3> start;      // of the pass, in the body's frame [m]
    std::vector<Vec3> predicted;  // in the body's frame [m]
    std::vector<Vec3> solved;     // after the impulses, in the body's frame [m]
    MeshSearch meshSearch;
    Overlap overlap;
    bool overlaps = false;  // `overlap` is valid: some of the cloth is inside the body or pierces it

    [[nodiscard]] MeshInStep meshInStep(bool atEnd) const;
  };

  bool chooseBodies(const Cloth& cloth, const std::vector<BodyStep>& bodies, const std::vector<Vec3>& positions,
                    const Eigen::AlignedBox3d& ends);
  ClothMotion motionIn(const BodyStep& step, const ClothModel& model, const std::vector<Vec3>& start,
                       const std::vector<Vec3>& end);
  bool isKnownClearOf(const Cloth& cloth, const BodyStep& step, const SearchableMesh& mesh,
                      const std::vector<Vec3>& positions);
  void addNearBody(const Cloth& cloth, const BodyStep& step, SearchableMesh* mesh);
  void findOverlaps(const Cloth& cloth, bool atEnd, bool first);
  void extendBoundsForRecovery();
  bool findPrimitiveOverlap(const Cloth& cloth, NearBody& near, CapsuleSolid&& solid);
  [[nodiscard]] ClothInBody clothIn(const Cloth& cloth, const NearBody& near, std::span<const Vec3> predicted);
  void runPasses(const Cloth& cloth, ContactReport& report, std::vector<Vec3>& positions);
  [[nodiscard]] bool overlaps() const;
  [[nodiscard]] std::vector<bool> verticesAtOverlap(const Cloth& cloth, const NearBody& near);
  void limitDisplacementsAtOverlap(const Cloth& cloth);
  void limitVelocitiesAtOverlap(const Cloth& cloth, ClothState& state) const;
  void prepareBodyFrames(const Cloth& cloth, const std::vector<Vec3>* previous);
  void extendBoundsForDeformation(const Cloth& cloth, const NearBody& near);
  bool searchVertexContacts(const Cloth& cloth, bool atEnd);
  void addSubstepContact(const Cloth& cloth, const ContactConstraint& contact, std::vector<SubstepContact>& found);
  bool searchSharpFeatures(const Cloth& cloth, bool atEnd);
  bool searchPlanes(const Cloth& cloth, bool atEnd);
  bool requestPlanesAround(const Cloth& cloth, bool all, const std::vector<Vec3>& positions);
  int applySeparatingPlanes(const Cloth& cloth, bool atEnd, std::vector<Vec3>& positions);
  [[nodiscard]] bool hasMeshes() const;
  [[nodiscard]] double maxContactOffset() const;
  void transformSolved(const Cloth& cloth, const std::vector<Vec3>& positions);
  void tightenBounds();
  const std::vector<OwnedFeatures>& ownedOf(const Cloth& cloth);
  const ClothClusters& clustersOf(const ClothModel& model);
  const std::vector<int>& piecesOf(const ClothModel& model);
  void searchPrimitive(const Cloth& cloth, const ClothInBody& inBody, const PrimitiveSearch& body);
  bool runPass(const Cloth& cloth, const std::vector<Vec3>* previous, ContactReport& report,
               std::vector<Vec3>& positions);
  void correctPositions(const Cloth& cloth, std::vector<Vec3>& positions);
  [[nodiscard]] bool needsAnotherPass(const Cloth& cloth, const std::vector<Vec3>* previous,
                                      const std::vector<Vec3>& positions) const;
  [[nodiscard]] double gapTo(const NearBody& near, const Vec3& position, double maxGap) const;
  void correctVelocities(const Cloth& cloth, ClothState& state);
  SearchableMesh* meshOf(const BodyStep& step);

  ModelCache<std::vector<OwnedFeatures>> owned_;
  ModelCache<ClothClusters> clusters_;
  ModelCache<std::vector<int>> pieces_;  // one vertex of each connected piece
  std::uint64_t models_ = 0;             // number of models so far
  ModelCache<std::vector<double>> inverseMass_;
  // Never iterated over, since the order of addresses varies.
  std::map<const Body*, std::unique_ptr<SearchableMesh>> meshes_;
  std::map<const Body*, MeshClearance> clearances_;
  std::vector<Vec3> localStart_;  // used by motionIn [m]
  std::vector<Vec3> localEnd_;    // likewise
  std::vector<NearBody> near_;
  std::size_t nearCount_ = 0;
  std::vector<double> displacementBounds_;  // of each vertex from the start of the pass [m]
  std::vector<double> displacements_;       // of each vertex by the impulses [m]
  std::vector<Vec3> solved_;                // positions after the impulses [m]
  std::vector<bool> moved_;                 // whether planes moved the vertex from there
  std::size_t firstOfMeshes_ = 0;           // first of the planes that belong to meshes
  std::vector<double> deformations_;        // maximum displacement of deforming meshes near each vertex [m]
  Candidates candidates_;
  std::vector<ContactGoal> goals_;
  std::vector<ContactConstraint> active_;
  ContactSolver solver_;
  SeparatingPlaneFilter filter_;
  Workers workers_;
  std::vector<Vec3> previous_;   // result of the pass before [m]
  std::vector<Vec3> predicted_;  // [m]
  /// A vertex inside a body or next to such cloth.
  struct SlowedVertex {
    std::size_t vertex = 0;
    Vec3 displacement = Vec3::Zero();  // of the body there over the step [m]
  };
  std::vector<SlowedVertex> slowed_;
};

}  // namespace drape::sim::contact
