#pragma once

#include "sim/cloth_state.hpp"
#include "sim/contact/broad_phase/mesh_clearance.hpp"
#include "sim/contact/constraints/mesh_search.hpp"
#include "sim/contact/constraints/primitive_search.hpp"
#include "sim/contact/contact_report.hpp"
#include "sim/contact/recovery/overlap.hpp"
#include "sim/contact/separating_planes/separating_plane_filter.hpp"
#include "sim/contact/solve/contact_solver.hpp"
#include "sim/model_cache.hpp"
#include "sim/step_parameters.hpp"
#include "sim/workers.hpp"

#include <map>
#include <memory>
#include <vector>

namespace drape {

/// Keeps a cloth out of bodies (docs/theory/contact.md).
///
/// A step is judged in the frame of each body, in which its start is where the body carries it. There every triangle of
/// the cloth has a plane between itself and each part of the body that it could reach. Impulses with friction move the
/// cloth to where it should be; then no vertex is let across the planes of its triangles, so that whatever the impulses
/// did, nothing intersects. Where the cloth went far the planes no longer lie well, and the search is done again from
/// where it is now.
class BodyContact {
 public:
  /// Corrects positions and velocities of `state`, which a solver has moved there from `start`.
  /// @param points where there was contact; added to
  void resolve(const ClothModel& model, const StepParameters& parameters, const std::vector<BodyStep>& bodies,
               const std::vector<Vec3>& start, ClothState& state, ContactReport& report,
               std::vector<ContactPoint>& points);

  /// Whether a cloth that a step takes from one box into another could come near any of the bodies [m].
  [[nodiscard]] bool couldReachAnyBody(const StepParameters& parameters, const std::vector<BodyStep>& bodies,
                                       const Eigen::AlignedBox3d& start, const Eigen::AlignedBox3d& end);

  /// Whether cloth on its way from `start` to `end` is so near to a body that the step should be taken in rounds.
  /// Follows from nothing but that.
  /// @param spread how far from `end` it may arrive [m]
  [[nodiscard]] bool isNearAnyBody(const ClothModel& model, const StepParameters& parameters,
                                   const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start,
                                   const std::vector<Vec3>& end, double spread);

 private:
  struct Cloth {
    const ClothModel& model;
    const StepParameters& parameters;
    const std::vector<Vec3>& start;      // [m]
    const std::vector<Vec3>& predicted;  // [m]
  };
  struct NearBody {
    const BodyStep* step = nullptr;
    SearchableMesh* mesh = nullptr;  // of a box or a mesh
    ContactOffsets offsets;
    std::vector<Vec3> start;      // in the body's frame [m]
    std::vector<Vec3> predicted;  // in the body's frame [m]
    std::vector<Vec3> solved;     // where contacts let it go, in the body's frame [m]
    MeshSearch meshSearch;
    Overlap overlap;
    bool overlaps = false;  // it has an inside, and something of the cloth meets it there

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
  void prepareBodyFrames(const Cloth& cloth, const std::vector<Vec3>* safe);
  void extendBoundsForDeformation(const Cloth& cloth, const NearBody& near);
  bool searchVertexContacts(const Cloth& cloth, bool atEnd);
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
  void searchCapsule(const Cloth& cloth, const ClothInBody& inBody, const PrimitiveSearch& body);
  bool runPass(const Cloth& cloth, const std::vector<Vec3>* safe, ContactReport& report, std::vector<Vec3>& positions);
  void correctPositions(const Cloth& cloth, std::vector<Vec3>& positions);
  [[nodiscard]] bool needsAnotherPass(const Cloth& cloth, const std::vector<Vec3>* safe,
                                      const std::vector<Vec3>& positions) const;
  [[nodiscard]] double gapTo(const NearBody& near, const Vec3& prepareBodyFrames, double maximum) const;
  void correctVelocities(const Cloth& cloth, ClothState& state);
  SearchableMesh* meshOf(const BodyStep& step);

  ModelCache<std::vector<OwnedFeatures>> owned_;
  ModelCache<ClothClusters> clusters_;
  ModelCache<std::vector<int>> pieces_;  // a vertex of each
  std::uint64_t models_ = 0;             // for which there were clusters
  ModelCache<std::vector<double>> inverseMass_;
  std::map<const Body*, std::unique_ptr<SearchableMesh>> meshes_;  // looked up, never gone through
  std::map<const Body*, MeshClearance> clearances_;                // likewise
  std::vector<Vec3> localStart_;                                   // of wayIn [m]
  std::vector<Vec3> localEnd_;                                     // likewise
  std::vector<NearBody> near_;
  std::size_t nearCount_ = 0;
  std::vector<double> displacementBounds_;
  std::vector<double> displacements_;
  std::vector<Vec3> solved_;          // where contacts let the cloth go [m]
  std::vector<bool> moved_;           // from there
  std::size_t firstOfMeshes_ = 0;     // among the planes
  std::vector<double> deformations_;  // of meshes that move in themselves, near each vertex [m]
  Candidates found_;
  std::vector<ContactGoal> goals_;
  std::vector<ContactConstraint> active_;
  ContactSolver solver_;
  SeparatingPlaneFilter filter_;
  Workers workers_;
  std::vector<Vec3> safe_;
  std::vector<Vec3> predicted_;  // where the cloth is about to go [m]
  /// Of a vertex that is inside a body or beside what is.
  struct SlowedVertex {
    std::size_t vertex = 0;
    Vec3 move = Vec3::Zero();  // of the body there over the step [m]
  };
  std::vector<SlowedVertex> slowed_;
};

}  // namespace drape
