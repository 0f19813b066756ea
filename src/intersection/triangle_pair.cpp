#include "intersection/triangle_pair.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace drape {
namespace {

using Point = Eigen::Vector3d;

/// Whether all of these points lie strictly beyond one of the sides of a triangle that begin at these corners, as seen
/// in its projection. Quick, and enough for most neighbours in a sheet.
template <typename... Points>
bool beyondASide(const Facet& triangle, std::initializer_list<std::size_t> sides, const Points&... points) {
  const auto& corners = triangle.corners();
  const Projection p = triangle.projection();
  const int turn = orientation(corners[0], corners[1], corners[2], p);
  for (const std::size_t side : sides) {
    const Point& from = corners[side];
    const Point& to = corners[(side + 1) % 3];
    if (((turn * orientation(from, to, points, p) < 0) && ...)) {
      return true;
    }
  }
  return false;
}

/// Whether all of these points lie strictly on one side of a triangle's plane.
template <typename... Points>
bool besidePlane(const Facet& triangle, const Point& first, const Points&... others) {
  const int side = triangle.sideOf(first);
  return side != 0 && ((triangle.sideOf(others) == side) && ...);
}

/// Whether a triangle is clearly apart from another.
bool apart(const Facet& triangle, const Facet& other) {
  const auto& [a, b, c] = other.corners();
  return triangle.hasArea() && (beyondASide(triangle, {0, 1, 2}, a, b, c) || besidePlane(triangle, a, b, c));
}

/// Whether a triangle is clearly apart from another, but for the corner 0 that they share.
bool apartButForCorner(const Facet& triangle, const Facet& other) {
  const auto& [corner, a, b] = other.corners();
  return triangle.hasArea() && (beyondASide(triangle, {0, 2}, a, b) || besidePlane(triangle, a, b));
}

/// Whether the boundary of a triangle (all of it, where it has no area) meets another triangle.
bool boundaryMeets(const Facet& triangle, const Facet& other) {
  if (!triangle.hasArea()) {
    return meet(triangle.segment(), other);
  }
  const auto& [a, b, c] = triangle.corners();
  return meet({a, b}, other) || meet({b, c}, other) || meet({c, a}, other);
}

/// Whether a point that is farthest from the shared corner within `triangle`, in whatever direction, lies in `other`.
/// These points make up the side opposite to the corner; only a triangle without area may have its corner there.
bool farSideMeets(const Facet& triangle, const Facet& other) {
  const auto& [corner, a, b] = triangle.corners();
  if (!triangle.hasArea()) {
    const auto [first, last] = std::minmax(a, b, before);
    if (!before(corner, first) && !before(last, corner)) {
      return (a != corner && meet({a, a}, other)) || (b != corner && meet({b, b}, other));
    }
  }
  return meet({a, b}, other);
}

/// Beyond which end of a segment a point of its line lies: -1 before its first, 1 after its last, 0 on it.
int beyond(const Point& point, const Segment& segment) {
  const auto [first, last] = std::minmax(segment.from, segment.to, before);
  return before(point, first) ? -1 : before(last, point) ? 1 : 0;
}

}  // namespace

bool meet(const Facet& first, const Facet& second) {
  if (apart(first, second) || apart(second, first)) {
    return false;
  }
  // What two convex pieces have in common ends on the boundary of one of them.
  return boundaryMeets(first, second) || boundaryMeets(second, first);
}

bool meetBeyondCorner(const Facet& first, const Facet& second) {
  if (apartButForCorner(first, second) || apartButForCorner(second, first)) {
    return false;
  }
  // Along a ray from the corner both triangles are there from the start, so what they share ends at the far side of
  // one.
  return farSideMeets(first, second) || farSideMeets(second, first);
}

bool meetBeyondEdge(const Facet& first, const Facet& second) {
  const auto& [u, v, a] = first.corners();
  const Point& b = second.corners()[2];
  if (u == v) {
    return meetBeyondCorner(first, second);
  }
  if (first.hasArea() && second.hasArea()) {
    const Projection p = first.projection();
    return orientation(u, v, a, p) == orientation(u, v, b, p) && first.sideOf(b) == 0;
  }
  if (first.hasArea() || second.hasArea()) {
    return false;
  }
  const int side = beyond(a, {u, v});
  return side != 0 && beyond(b, {u, v}) == side;
}

}  // namespace drape
