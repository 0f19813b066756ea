#pragma once

#include "sim/contact/contact_parameters.hpp"
#include "sim/contact/contact_report.hpp"
#include "sim/contact/self/collision_free_patches.hpp"
#include "sim/contact/self/memory.hpp"
#include "sim/contact/self/patch_updater.hpp"
#include "sim/contact/self/point_hash.hpp"
#include "sim/contact/self/response.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/forces/substep_contact.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/model_cache.hpp"

#include <array>
#include <memory>
#include <vector>

namespace drape::sim::contact {

/// The thickness of self-collision by the hash [m]: `selfThickness`, or three quarters of the mean rest length of the
/// springs if that is 0. The point of a right-angled triangle with two legs of length e that is farthest from its
/// corners has the distance e / sqrt(2) = 0.71 e from them. With a smaller thickness a vertex can slip through between
/// three others.
[[nodiscard]] double selfThicknessOf(const ClothModel& model, const ContactParameters& parameters);

/// Self-collision by the method of the paper, sec. 5.2 (docs/theory/method.md), vertices against vertices:
///
/// 1. Collision-free patches (PatchUpdater), which cannot collide with themselves.
/// 2. Near pairs of vertices of different patches, by a hash over two grids (PointHash).
/// 3. A response with thickness and friction (SelfResponse).
///
/// docs/theory/contact.md describes its limits. A search finds pairs within the reach: the thickness plus a margin. The
/// list is valid until the relative displacement of two vertices exceeds the margin. Then the patches are checked,
/// invalid ones are grown anew, and pairs are searched again. Known pairs are kept while they are within reach. Each
/// search shifts the grids, so that a pair that the grids separate in one search is found in another. Vertices that are
/// connected at rest are never pairs: the ends of one spring, and vertices whose rest distance is less than the
/// thickness.
class SelfContact {
 public:
  /// Finds the pairs that can come into contact in a step from `state`, for solvers that resolve contacts in their
  /// substeps. Searches anew if the list of pairs is not valid where the velocities move the cloth, and stores the list
  /// in `state`.
  /// @param ahead positions extrapolated by the velocities [m]  @param found the contacts are appended
  void findSubstepContacts(const ClothModel& model, const CommonParameters& parameters,
                           const ContactParameters& contact, const std::vector<Vec3>& ahead, ClothState& state,
                           std::vector<SubstepContact>& found);

  /// Corrects the predicted state.
  /// @param start positions at the start of the step [m]  @param points the active contacts are appended
  /// @param stepFraction length of this contact substep over that of the user's step [-]; scales the push-out
  /// @returns number of active contacts
  int resolve(const ClothModel& model, const ContactParameters& contact, double timeStep,
              const std::vector<Vec3>& start, ClothState& state, std::vector<ContactPoint>& points,
              double stepFraction = 1.0);

 private:
  [[nodiscard]] double thicknessOf(const ClothModel& model, const ContactParameters& contact);
  [[nodiscard]] bool pairListIsValid(const ClothModel& model, double thickness, const ClothState& state) const;
  void updatePairs(const ClothModel& model, double thickness, const std::vector<Vec3>& start, ClothState& state);
  std::shared_ptr<SelfContactMemory> unusedMemory();
  void gatherPointsNearOtherPatches(const CollisionFreePatches& patches, float reach);
  void keepKnownPairs(const SelfContactMemory& old, const CollisionFreePatches& patches, double reach,
                      std::vector<VertexPair>& pairs) const;
  static void removeConnectedPairs(const ClothModel& model, double thickness, std::vector<VertexPair>& pairs);

  ModelCache<PatchMesh> mesh_;
  ModelCache<double> edge_;
  PatchUpdater patches_;
  PointHash hash_;
  SelfResponse response_;
  PositionLanes positions_, startPositions_;  // at the end and the start of the step [m]
  PositionLanes sorted_;                      // at the end, patch by patch
  std::vector<LaneBox> boxes_;                // per patch
  std::vector<char> near_;                    // by index in `sorted_`: it may be near another patch
  std::vector<std::int32_t> inside_;          // scratch
  SurfacePoints points_;                      // the points that the hash compares
  std::vector<std::int32_t> pointOf_;         // by vertex: index in points_, or -1
  std::vector<VertexPair> found_;
  std::vector<std::uint64_t> colours_;                          // scratch of colourPairs
  std::array<std::shared_ptr<SelfContactMemory>, 4> memories_;  // for reuse, once no state has them
};

}  // namespace drape::sim::contact
