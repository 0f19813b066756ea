#pragma once

#include "sim/model/vector.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace drape::sim::contact {

/// The corners of a triangle in space [m].
using Corners = std::array<Vec3, 3>;

/// The point with the given barycentric coordinates.
[[nodiscard]] inline Vec3 pointAt(const Corners& corners, const Vec3& weights) {
  return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
}

[[nodiscard]] inline const Vec3& vectorAt(std::span<const Vec3> points, int i) {
  return points[i];
}

[[nodiscard]] inline Corners cornersOf(std::span<const Vec3> points, const Triangle& triangle) {
  return {vectorAt(points, triangle[0]), vectorAt(points, triangle[1]), vectorAt(points, triangle[2])};
}

/// A closest point counts as interior if all of its barycentric coordinates exceed this margin [-].
inline constexpr double insideMargin = 1e-3;

/// Whether a point with these barycentric coordinates lies in the interior of its triangle.
[[nodiscard]] inline bool isInside(const Vec3& weights) {
  return (weights.array() > insideMargin).all();
}

/// The same for a point of an edge: 0 and 1 are its ends.
[[nodiscard]] inline bool isInside(double along) {
  return along > insideMargin && along < 1.0 - insideMargin;
}

/// The barycentric coordinates of corner k.
[[nodiscard]] Vec3 onCorner(std::size_t k);
/// The barycentric coordinates of a point on side k, which runs from corner k (0) to the next corner (1).
[[nodiscard]] Vec3 onSide(std::size_t k, double along);

/// The unit normal of a triangle on its front, from which its corners are counter-clockwise; the y axis if the triangle
/// has no area.
[[nodiscard]] Vec3 faceNormal(const Corners& corners);

/// The minimum and the maximum of a triangle's coordinates along a direction [m].
[[nodiscard]] inline double lowestAlong(const Vec3& direction, const Corners& corners) {
  return std::min({direction.dot(corners[0]), direction.dot(corners[1]), direction.dot(corners[2])});
}
[[nodiscard]] inline double highestAlong(const Vec3& direction, const Corners& corners) {
  return std::max({direction.dot(corners[0]), direction.dot(corners[1]), direction.dot(corners[2])});
}

[[nodiscard]] inline Eigen::AlignedBox3d boxAround(const Corners& corners) {
  return {corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]), corners[0].cwiseMax(corners[1]).cwiseMax(corners[2])};
}

/// The box, extended by `by` on all sides [m].
[[nodiscard]] inline Eigen::AlignedBox3d inflated(const Eigen::AlignedBox3d& box, double by) {
  return {(box.min().array() - by).matrix(), (box.max().array() + by).matrix()};
}

}  // namespace drape::sim::contact
