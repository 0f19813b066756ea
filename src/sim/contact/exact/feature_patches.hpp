#pragma once

#include "sim/contact/exact/pair_gap.hpp"
#include "sim/contact/self/patch_updater.hpp"
#include "sim/model/model_cache.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// The patches to which the features of a cloth belong.
struct PatchLabels {
  std::shared_ptr<const CollisionFreePatches> patches;
  /// The common patch of all triangles around a vertex or an edge, and the patch of a triangle; -1: there is none.
  /// Empty if there are no patches.
  std::vector<int> ofVertex, ofEdge, ofTriangle;
};

/// The number of sets of patches: a partition of the cloth, and patches across borders.
inline constexpr std::size_t patchSets = 1 + furtherPatchSets;

/// The sets of collision-free patches to which the features of a cloth belong. While a patch is collision-free, no two
/// of its triangles intersect, so that pairs of its features need no check.
using FeaturePatches = std::array<PatchLabels, patchSets>;

using SharedFeaturePatches = std::shared_ptr<const FeaturePatches>;

/// Finds and checks the collision-free patches of a cloth for exact self-collision.
class PatchFinder {
 public:
  /// The patches of the cloth at `positions` [m]. Those of `last` are kept if they are valid.
  /// @param maxDistance up to which pairs are searched [m]
  [[nodiscard]] PatchHistory update(const ClothModel& model, double maxDistance, std::span<const Vec3> positions,
                                    const PatchHistory& last);

  /// The patches of the features. Equal patches have the same address in successive calls.
  [[nodiscard]] SharedFeaturePatches ofFeatures(const FeatureMesh& mesh, const PatchHistory& history);

  /// Removes the features of patches that are not collision-free at `positions` [m], so that their pairs are checked.
  /// @param patches replaced if there are any  @returns whether there are any
  [[nodiscard]] bool removeInvalid(std::span<const Vec3> positions, SharedFeaturePatches& patches);

 private:
  void setPositions(std::span<const Vec3> positions);
  void updateAcrossBorders(const PatchMesh& mesh, bool isFine, const PatchHistory& last, PatchHistory& next);
  [[nodiscard]] bool removeMarked(PatchLabels& labels) const;

  ModelCache<PatchMesh> mesh_;
  ModelCache<double> meanEdge_;  // [m]
  PatchUpdater updater_;
  PatchGrower grower_;  // of patches across borders
  PatchCheck check_;
  PositionLanes positions_;  // relative to the first vertex [m]
  std::vector<char> valid_;
  SharedFeaturePatches last_;
};

}  // namespace drape::sim::contact
