#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/contact/contact_report.hpp"
#include "sim/contact/self/collision_free_patches.hpp"
#include "sim/contact/self/memory.hpp"
#include "sim/contact/self/point_hash.hpp"
#include "sim/contact/self/response.hpp"
#include "sim/model_cache.hpp"
#include "sim/step_parameters.hpp"

#include <array>
#include <memory>
#include <vector>

namespace drape {

/// The thickness [m] that self-collision keeps: `selfThickness`, or three quarters of the mean rest length of the
/// springs where that is 0. A vertex over the middle of a right-angled triangle with two legs of length e is
/// e / sqrt(2) = 0.71 e away from the corners, so at less a vertex can slip through between three others.
[[nodiscard]] double selfThicknessOf(const ClothModel& model, const ContactParameters& parameters);

/// Self-collision by the paper's scheme (sec. 5.2), vertex to vertex: collision-free sub-surfaces (PatchGrower), near
/// pairs of different ones by a hash over two grids (PointHash), and a response with thickness and friction
/// (SelfResponse). docs/theory/contact.md tells what it lets through.
///
/// Pairs are looked for within the thickness and a margin, and the list of them serves until two vertices have moved
/// against each other by that margin; then the patches are checked, grown anew where they hold no longer, and the pairs
/// looked for again. A pair that has once been found is kept while it is within reach, and each search moves the grids,
/// so that a pair which the grids part in one search is found in another. Pairs that the rest shape connects never
/// count: ends of one spring, and vertices whose distance at rest is less than the thickness.
class SelfContact {
 public:
  /// Corrects the state that a solver has left.
  /// @param start positions when the step began [m]  @param points what was in contact is appended
  /// @param stepFraction that this is of the user's step [-]: as much of what began it too near is pushed apart
  /// @returns how many pairs were in contact
  int resolve(const ClothModel& model, const StepParameters& parameters, const std::vector<Vec3>& start,
              ClothState& state, std::vector<ContactPoint>& points, double stepFraction = 1.0);

 private:
  [[nodiscard]] bool pairListIsValid(const ClothModel& model, double thickness, const ClothState& state) const;
  void updatePairs(const ClothModel& model, double thickness, const std::vector<Vec3>& start, ClothState& state);
  std::shared_ptr<SelfContactMemory> unusedMemory();
  std::shared_ptr<const CollisionFreePatches> patchesFor(const ClothModel& model, const SelfContactMemory* old,
                                                         SelfContactMemory& next);
  void gatherPointsNearOtherPatches(const CollisionFreePatches& patches, float reach);
  void keepKnownPairs(const SelfContactMemory& old, const CollisionFreePatches& patches, double reach,
                      std::vector<VertexPair>& pairs) const;
  static void removeConnectedPairs(const ClothModel& model, double thickness, std::vector<VertexPair>& pairs);

  ModelCache<PatchMesh> mesh_;
  ModelCache<double> edge_;
  PatchGrower grower_;
  PatchCheck check_;
  std::vector<char> valid_;
  PointHash hash_;
  SelfResponse response_;
  PositionLanes positions_, startPositions_;  // at the end and the start of the step [m]
  PositionLanes sorted_;                      // at the end, patch by patch
  std::vector<LaneBox> boxes_;
  std::vector<char> near_;
  std::vector<std::int32_t> inside_;
  SurfacePoints points_;
  std::vector<std::int32_t> pointOf_;  // by vertex, or -1
  std::vector<VertexPair> found_;
  std::vector<std::uint64_t> colours_;
  std::array<std::shared_ptr<SelfContactMemory>, 4> memories_;
};

}  // namespace drape
