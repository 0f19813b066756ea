#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace drape {

/// A triangle mesh at one moment.
struct Surface {
  std::span<const Eigen::Vector3d> positions;     ///< [m]
  std::span<const std::array<int, 3>> triangles;  ///< three different indices into positions each
};

/// Two triangles, by their indices.
struct TrianglePair {
  int first = 0;
  int second = 0;
  bool operator==(const TrianglePair&) const = default;
  auto operator<=>(const TrianglePair&) const = default;
};

/// The pairs of a surface's triangles that intersect, first < second, sorted. Decided without rounding:
/// two triangles that share no vertex intersect when they have a point in common (touching counts);
/// two that share one vertex, when they have another point in common;
/// two that share an edge, when they have a point in common outside it (one is folded flat onto the other);
/// two with the same three vertices always. A triangle without area counts as the segment or point that it is.
/// Throws std::invalid_argument for a position that is not finite or an index that does not fit.
[[nodiscard]] std::vector<TrianglePair> intersectingPairs(const Surface& surface);

/// The pairs of a triangle of one surface and a triangle of another that have a point in common, sorted.
[[nodiscard]] std::vector<TrianglePair> intersectingPairs(const Surface& first, const Surface& second);

/// The triangles that are not wholly in front of the plane through three points (from where these turn
/// counter-clockwise): those with a corner in it or behind it, ascending.
[[nodiscard]] std::vector<int> trianglesReaching(const Surface& surface, const std::array<Eigen::Vector3d, 3>& plane);

}  // namespace drape
