#pragma once

#include "scene/scene.hpp"

#include <functional>

namespace drape {

/// What contact cost in a run and what it let through.
struct CollisionRun {
  int steps = 0;
  double stepSeconds = 0.0;     ///< mean of a step, contact included [s]
  double bodySeconds = 0.0;     ///< mean of what bodies took of it [s]
  double selfSeconds = 0.0;     ///< mean of what self-collision took of it [s]
  double longestContact = 0.0;  ///< the 99th percentile of both together [s]
  int contacts = 0;             ///< most in a step
  int overlapping = 0;          ///< most triangles that were inside a body when a step began
  int infeasible = 0;           ///< most vertices in a step that found no place between bodies
  int pairsWithSelf = 0;        ///< most triangle pairs of the cloth that intersected when it was looked
  int pairsWithBodies = 0;      ///< most pairs of a cloth's and a body's triangle
  double shareWithSelf = 0.0;   ///< of the times that it was looked, those with pairs of the cloth [-]
  bool finite = true;
};

/// Runs a scene, its bodies included, for so long and looks for intersecting triangles, by the exact intersection test,
/// at every `lookEvery`-th step. 0: never.
/// @param mayStop is called before each step and may throw
[[nodiscard]] CollisionRun runCollision(const Scene& scene, double seconds, int lookEvery,
                                        const std::function<void()>& mayStop);

}  // namespace drape
