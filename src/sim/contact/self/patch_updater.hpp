#pragma once

#include "sim/contact/self/collision_free_patches.hpp"

#include <memory>
#include <vector>

namespace drape::sim::contact {

/// Collision-free patches of a moving cloth, and when they were grown.
struct PatchHistory {
  std::shared_ptr<const CollisionFreePatches> patches;  ///< null: there are none yet
  int updatesSinceGrowth = 0;                           ///< since all patches were grown anew
  int patchesGrown = 0;                                 ///< number of patches then
};

/// Keeps the patches of a moving cloth collision-free. It keeps valid patches and grows invalid ones anew. After
/// `maxUpdatesPerGrowth` updates it grows all patches anew, since cloth that has become flat needs fewer. It does so
/// too when repairs have more than doubled the number of patches.
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
