#pragma once

#include "sim/contact/exact/pair_gap.hpp"

#include <span>

namespace drape::sim::contact {

/// What is required of a pair in a step.
struct SeparationGoal {
  double distance = 0.0;  ///< pairs that stay farther apart all the way are separated [m]
  double kept = 0.0;      ///< distance along a normal that others keep, at most `distance` [m]
};

/// A pair of features in a step in which all vertices move on straight lines.
struct PairInStep {
  enum class Kind {
    Separated,     ///< it certainly does not meet in the step
    NotSeparated,  ///< it may meet
    Touching       ///< no plane that separates it at the start was found
  };
  Kind kind = Kind::Separated;
  Vec3 normal = Vec3::UnitY();  ///< of a plane that separates the pair at the start, from the second to the first
  double separation = 0.0;      ///< distance along the normal that the pair must keep [m]
};

/// Decides whether a pair is separated in a step. `Separated` is certain, for any rounding. It has one of three proofs:
///
/// 1. Along one normal the first feature lies above the second at the start and at the end, by at least the separation
///    that the pair keeps. This holds in between too. The normals of the closest points at both times are tried.
/// 2. At the end it is as far apart along another normal, and in between it stays farther apart than half of that
///    (comesWithin). So a pair can turn by a little.
/// 3. The pair stays farther apart than goal.distance (comesWithin).
///
/// The result is `Separated` for each pair that stays farther apart than `approachSlack` times goal.distance.
/// @param start, end positions [m]
[[nodiscard]] PairInStep separationInStep(const PairVertices& vertices, std::span<const Vec3> start,
                                          std::span<const Vec3> end, const SeparationGoal& goal);

}  // namespace drape::sim::contact
