#include "sim/contact/self/patch_updater.hpp"

namespace drape::sim::contact {
namespace {

/// All patches are grown anew when repairs have made their number larger than twice the grown number plus this.
constexpr int extraRepairedPatches = 4;

}  // namespace

void PatchUpdater::setBorderMargin(float margin) {
  grower_.setBorderMargin(margin);
  check_.setBorderMargin(margin);
}

PatchHistory PatchUpdater::update(const PatchMesh& mesh, const PositionLanes& positions, const PatchHistory& last,
                                  int maxUpdatesPerGrowth) {
  const bool known = last.patches != nullptr;
  const bool aged = known && last.updatesSinceGrowth >= maxUpdatesPerGrowth && last.patches->count() > 1;
  if (known && !aged) {
    PatchHistory next{last.patches, last.updatesSinceGrowth + 1, last.patchesGrown, {}};
    if (check_.failures(*last.patches, positions, valid_) == 0) {
      return next;
    }
    auto repaired = std::make_shared<CollisionFreePatches>();
    grower_.repair(mesh, positions, *last.patches, valid_, *repaired);
    if (repaired->count() <= 2 * last.patchesGrown + extraRepairedPatches) {
      next.patches = repaired;
      return next;
    }
  }
  auto patches = std::make_shared<CollisionFreePatches>();
  grower_.grow(mesh, positions, *patches);
  const int count = patches->count();
  return {std::move(patches), 0, count, {}};
}

}  // namespace drape::sim::contact
