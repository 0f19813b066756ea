#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace drape::intersection {

/// A triangle mesh at one time.
struct Surface {
  std::span<const Eigen::Vector3d> positions;     ///< [m]
  std::span<const std::array<int, 3>> triangles;  ///< three different indices into positions each
};

/// Two triangles, by their indices.
struct TrianglePair {
  int first = 0;
  int second = 0;
  bool operator==(const TrianglePair&) const = default;
  auto operator<=>(const TrianglePair&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy sees a 0 here
};

/// The intersecting pairs of triangles of a surface, first < second, sorted. Computed without rounding errors:
/// two triangles without common vertices intersect if they have a point in common (touching counts);
/// two with one common vertex, if they have another point in common;
/// two with a common edge, if they have a point in common outside it (one is folded flat onto the other);
/// two with the same three vertices always. A triangle without area counts as a segment or point.
/// Throws std::invalid_argument if a position is not finite or an index is out of range.
[[nodiscard]] std::vector<TrianglePair> intersectingPairs(const Surface& surface);

/// The pairs of triangles of two surfaces that have a point in common, sorted.
[[nodiscard]] std::vector<TrianglePair> intersectingPairs(const Surface& first, const Surface& second);

/// The triangles with a corner in or behind the plane through three points, ascending. Seen from its front, the three
/// points are in counter-clockwise order.
[[nodiscard]] std::vector<int> trianglesReaching(const Surface& surface, const std::array<Eigen::Vector3d, 3>& plane);

}  // namespace drape::intersection
