#pragma once

#include "sim/contact/self/collision_free_patches.hpp"

#include <memory>
#include <vector>

namespace drape::sim::contact {

/// Collision-free patches of a moving cloth, and when they were grown.
struct PatchHistory {
  std::shared_ptr<const CollisionFreePatches> patches;  ///< null: there are none yet
  int updatesSinceGrowth = 0;                           ///< number of updates since all patches were grown anew
  int patchesGrown = 0;                                 ///< number of patches right after that
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
