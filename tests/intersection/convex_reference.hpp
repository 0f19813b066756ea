#pragma once

#include <Eigen/Core>
#include <array>

namespace drape::intersection::testing {

/// A triangle with small integer coordinates.
using WholeTriangle = std::array<Eigen::Vector3i, 3>;

/// An independent intersection test: two triangles intersect if 0 is in the convex hull of the differences of their
/// corners. By Caratheodory's theorem it suffices to test all simplices of these. Slow, and exact for coordinates up to
/// about 100.
[[nodiscard]] bool meetByDifferences(const WholeTriangle& a, const WholeTriangle& b);

/// Whether two triangles with the same corner 0 have another point in common: a direction that leads into both.
[[nodiscard]] bool meetBeyondCornerByCones(const WholeTriangle& a, const WholeTriangle& b);

/// Whether two triangles with the same corners 0 and 1 have a point in common outside the edge between these: a
/// direction from one of its ends that leads into both and off the edge.
[[nodiscard]] bool meetBeyondEdgeByCones(const WholeTriangle& a, const WholeTriangle& b);

}  // namespace drape::intersection::testing
