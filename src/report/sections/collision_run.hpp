#pragma once

#include "scene/scene.hpp"

#include <functional>

namespace drape::report::sections {

/// The cost of contact in a run, and the intersections that it left.
struct CollisionRun {
  int steps = 0;
  double stepSeconds = 0.0;     ///< mean of a step, contact included [s]
  double bodySeconds = 0.0;     ///< mean part of the bodies [s]
  double selfSeconds = 0.0;     ///< mean part of self-collision [s]
  double contactSeconds = 0.0;  ///< mean part of both and of contacts in the substeps of the solver [s]
  double longestContact = 0.0;  ///< 99th percentile of both together [s]
  double longestSelf = 0.0;     ///< 99th percentile of self-collision [s]
  /// Maximum of the total energy above its start, as a share of m g D with D the diagonal of the rest shape [-]; not a
  /// number if a body moves, which does work.
  double energyGained = 0.0;
  double endSpeed = 0.0;       ///< root mean square speed of the vertices in the last 0.2 s [m/s]
  int contacts = 0;            ///< maximum in a step
  int overlapping = 0;         ///< maximum number of triangles inside a body at the start of a step
  int infeasible = 0;          ///< maximum number of infeasible vertices in a step
  int pairsWithSelf = 0;       ///< maximum number of self-intersecting triangle pairs in a count
  int pairsWithBodies = 0;     ///< maximum number of intersecting pairs of a cloth and a body triangle
  double shareWithSelf = 0.0;  ///< share of the counts with self-intersecting pairs [-]
  bool finite = true;
};

/// Runs a scene with its bodies for that time and counts intersecting triangles, with the exact intersection test, at
/// every `countEvery`-th step. 0: never.
/// @param checkStop is called before each step and may throw
[[nodiscard]] CollisionRun runCollision(const scene::Scene& scene, double seconds, int countEvery,
                                        const std::function<void()>& checkStop);

}  // namespace drape::report::sections
