#pragma once

#include "report/references.hpp"
#include "scene/scene.hpp"

#include <functional>
#include <vector>

namespace drape::report::sections {

/// The converged motion of a cloth in its scene, with the same contact, and how well it is known.
struct ContactReference {
  Reference reference;
  /// How far two starts that differ by up to a micrometre part until checkpoint k: mean distance, mean of two pairs
  /// [m].
  std::vector<double> parting;
};

/// Halves the steps of Verlet in double, from the time step of the settings on, or from the first one with which the
/// cloth does not blow up. Contact acts once in a step, so its error shrinks too. Ends when every
/// checkpoint changes by at most 10 um, when halving no longer helps, or before a run of more than about `maxSeconds`
/// on one core (by the size of the cloth, so that each machine gives the same bits).
/// @param settings those of the method; a solver's own meaning of self-collision must be resolved already
/// @param checkStop is called at each step and may throw
[[nodiscard]] ContactReference contactReference(const scene::Scene& scene, const settings::Settings& settings,
                                                int checkpoints, double maxSeconds,
                                                const std::function<void()>& checkStop);

}  // namespace drape::report::sections
