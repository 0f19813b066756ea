#pragma once

#include <Eigen/Core>
#include <array>

namespace drape::testing {

/// A triangle with small whole coordinates.
using WholeTriangle = std::array<Eigen::Vector3i, 3>;

/// What the judge must say, found in another way: two triangles meet when 0 is in the convex hull of the differences of
/// their corners, which by Caratheodory's theorem is a question to all of its simplices. Slow, and exact for
/// coordinates up to about 100.
[[nodiscard]] bool meetByDifferences(const WholeTriangle& a, const WholeTriangle& b);

/// Whether two triangles with the same corner 0 have more in common: some direction that leads into both.
[[nodiscard]] bool meetBeyondCornerByCones(const WholeTriangle& a, const WholeTriangle& b);

/// Whether two triangles with the same corners 0 and 1 have more in common than the edge between these: some direction
/// that leads from one of its ends into both, and off the edge.
[[nodiscard]] bool meetBeyondEdgeByCones(const WholeTriangle& a, const WholeTriangle& b);

}  // namespace drape::testing
