#pragma once

#include "sim/contact/self/collision_free_patches.hpp"
#include "sim/contact/self/float_lanes.hpp"
#include "sim/contact/self/response.hpp"

#include <memory>

namespace drape {

/// What self-collision knows from earlier steps. It belongs to the state of a cloth, since what is found next depends
/// on it: a state that is copied and gone on from takes the same steps again. Never changed once a state has it.
struct SelfContactMemory {
  std::shared_ptr<const CollisionFreePatches> patches;
  PositionLanes positions;  ///< where the vertices were when near pairs were looked for [m]
  ColouredPairs pairs;      ///< that were within reach then
  double thickness = 0.0;   ///< [m]
  double reach = 0.0;       ///< thickness and what two vertices may move against each other until the next search [m]
  int vertices = 0;
  int triangles = 0;
  int searches = 0;             ///< so far
  int searchesSinceGrowth = 0;  ///< since all patches were grown
  int patchesGrown = 0;         ///< how many there were then
};

}  // namespace drape
