#pragma once

#include "scene/scene.hpp"

#include <functional>

namespace drape {

/// What contact cost in a run and what it let through.
struct CollisionRun {
  int steps = 0;
  double stepSeconds = 0.0;        ///< mean of a step, contact included [s]
  double contactSeconds = 0.0;     ///< mean of what contact took of it [s]
  double selfSeconds = 0.0;        ///< mean of what self-collision took of that [s]
  double longestContact = 0.0;     ///< the 99th percentile of contact [s]
  int contacts = 0;                ///< most in a step
  int intersectingPairs = 0;       ///< most triangle pairs of the cloth that intersected when it was looked
  double intersectingShare = 0.0;  ///< of the times that it was looked, those with any [-]
  bool finite = true;
};

/// Runs a scene for so long and looks for intersecting triangles of the cloth, by the exact judge, at every
/// `lookEvery`-th step. 0: never.
/// @param mayStop is called before each step and may throw
[[nodiscard]] CollisionRun runCollision(const Scene& scene, double seconds, int lookEvery,
                                        const std::function<void()>& mayStop);

}  // namespace drape
