#pragma once

#include "sim/contact/exact/pair_gap.hpp"

#include <span>

namespace drape::sim::contact {

/// The distances that separationInStep requires of a pair in a step.
struct SeparationGoal {
  double distance = 0.0;  ///< a pair that stays farther apart in the whole step is separated [m]
  double kept = 0.0;      ///< distance that other pairs keep along a normal, at most `distance` [m]
};

/// A pair of features in a step in which all vertices move on straight lines.
struct PairInStep {
  enum class Kind {
    Separated,     ///< its features certainly do not meet in the step
    NotSeparated,  ///< they may meet
    Touching       ///< no plane was found that separates them at the start
  };
  Kind kind = Kind::Separated;
  Vec3 normal = Vec3::UnitY();  ///< of a plane that separates the pair at the start, from the second to the first
  double separation = 0.0;      ///< distance along the normal that the pair must keep [m]
};

/// Decides whether a pair is separated in a step. `Separated` is certain, whatever the rounding errors: one of three
/// proofs succeeds.
///
/// 1. Along one normal the first feature lies above the second at the start and at the end, by at least the separation
///    that the pair keeps. This holds in between too. The normals of the closest points at both times are tried.
/// 2. The pair turns by a little: at the end it is that far apart along another normal, and in between it stays farther
///    apart than half of that separation (comesWithin).
/// 3. The pair stays farther apart than goal.distance / approachSlack (comesWithin).
///
/// So each pair that stays farther apart than goal.distance is `Separated`.
/// @param start, end positions [m]
[[nodiscard]] PairInStep separationInStep(const PairVertices& vertices, std::span<const Vec3> start,
                                          std::span<const Vec3> end, const SeparationGoal& goal);

}  // namespace drape::sim::contact
