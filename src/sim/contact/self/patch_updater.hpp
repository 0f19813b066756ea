#pragma once

#include "sim/contact/self/collision_free_patches.hpp"

#include <array>
#include <memory>
#include <vector>

namespace drape::sim::contact {

/// The number of sets of patches across borders. With a partition alone, neighbours at borders belong to different
/// patches. On meshes with short edges these are most of the near pairs.
inline constexpr std::size_t furtherPatchSets = 2;

/// Collision-free patches of a moving cloth, and when they were grown.
struct PatchHistory {
  std::shared_ptr<const CollisionFreePatches> patches;  ///< null: there are none yet
  int updatesSinceGrowth = 0;                           ///< number of updates since all patches were grown anew
  int patchesGrown = 0;                                 ///< number of patches right after that
  /// Further sets of patches, for exact self-collision. Each is across the borders of all sets before it, and empty on
  /// meshes with long edges. Null: there are none yet.
  std::array<std::shared_ptr<const CollisionFreePatches>, furtherPatchSets> acrossBorders;
};

/// Keeps the patches of a moving cloth collision-free. It keeps valid patches and grows invalid ones anew (a repair).
/// After `maxUpdatesPerGrowth` updates it grows all patches anew, since cloth that has become flat needs fewer. It also
/// grows all patches anew when repairs have more than doubled their number.
class PatchUpdater {
 public:
  /// See BorderCheck; initially 0 [m].
  void setBorderMargin(float margin);

  /// The patches for the given positions. The result keeps `last.patches` if they are valid.
  [[nodiscard]] PatchHistory update(const PatchMesh& mesh, const PositionLanes& positions, const PatchHistory& last,
                                    int maxUpdatesPerGrowth);

 private:
  PatchGrower grower_;
  PatchCheck check_;
  std::vector<char> valid_;
};

}  // namespace drape::sim::contact
