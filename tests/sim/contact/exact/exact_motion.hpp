#pragma once

#include "sim/contact/exact/pair_gap.hpp"

#include <array>

namespace drape::sim::testing {

/// Two features, a vertex and a triangle or two edges, whose four vertices move on straight lines during the times 0
/// to 1. The vertices are in the order of PairVertices.
struct PairMotion {
  std::array<Vec3, 4> start;
  std::array<Vec3, 4> end;
  std::size_t firstCount = 1;
};

/// Proves in exact arithmetic that the features never meet. The proof is a division of the times 0 to 1 into intervals,
/// each with a direction along which the first feature lies above the second at both ends of the interval: then it does
/// so in between, since all vertices move on straight lines. Candidates for directions and a bound of the rounding
/// error come from floating-point numbers; what these do not decide is decided by rational numbers (GMP). Each pair
/// that stays apart has such a proof.
/// @returns false if the pair meets, or if no proof with intervals of at least 2^-48 was found
[[nodiscard]] bool provablyStaysApart(const PairMotion& motion);

}  // namespace drape::sim::testing
