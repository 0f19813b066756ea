#pragma once

#include "sim/contact/exact/pair_gap.hpp"
#include "sim/contact/self/patch_updater.hpp"
#include "sim/model/model_cache.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// The collision-free patches to which the features of a cloth belong. While a patch is collision-free, no two of its
/// triangles intersect, so that pairs of its features need no check.
struct FeaturePatches {
  std::shared_ptr<const CollisionFreePatches> patches;
  /// The common patch of all triangles around a vertex or an edge, and the patch of a triangle; -1: there is none.
  std::vector<int> ofVertex, ofEdge, ofTriangle;
};

using SharedFeaturePatches = std::shared_ptr<const FeaturePatches>;

/// Finds and checks the collision-free patches of a cloth for exact self-collision.
class PatchFinder {
 public:
  /// The patches of the cloth at `positions` [m]. Those of `last` are kept if they are valid.
  [[nodiscard]] PatchHistory update(const ClothModel& model, std::span<const Vec3> positions, const PatchHistory& last);

  /// The patches of the features. Equal patches have the same address in successive calls.
  [[nodiscard]] SharedFeaturePatches ofFeatures(const FeatureMesh& mesh, const PatchHistory& history);

  /// Removes the features of patches that are not collision-free at `positions` [m], so that their pairs are checked.
  /// @param patches replaced if there are any  @returns whether there are any
  [[nodiscard]] bool removeInvalid(std::span<const Vec3> positions, SharedFeaturePatches& patches);

 private:
  void setPositions(std::span<const Vec3> positions);

  ModelCache<PatchMesh> mesh_;
  PatchUpdater updater_;
  PatchCheck check_;
  PositionLanes positions_;  // relative to the first vertex [m]
  std::vector<char> valid_;
  SharedFeaturePatches last_;
};

}  // namespace drape::sim::contact
