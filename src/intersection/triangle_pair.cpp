#include "intersection/triangle_pair.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace drape::intersection {
namespace {

using Point = Eigen::Vector3d;

/// Whether the projections of all these points lie strictly outside one of the given sides of a triangle. Side k starts
/// at corner k. A fast test that decides most neighbours in a sheet.
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

/// Whether a triangle separates another by its sides or its plane.
bool apart(const Facet& triangle, const Facet& other) {
  const auto& [a, b, c] = other.corners();
  return triangle.hasArea() && (beyondASide(triangle, {0, 1, 2}, a, b, c) || besidePlane(triangle, a, b, c));
}

/// The same for triangles that share corner 0.
bool apartExceptCorner(const Facet& triangle, const Facet& other) {
  const auto& [corner, a, b] = other.corners();
  return triangle.hasArea() && (beyondASide(triangle, {0, 2}, a, b) || besidePlane(triangle, a, b));
}

/// Whether the boundary of a triangle (all of it if it has no area) intersects another triangle.
bool boundaryMeets(const Facet& triangle, const Facet& other) {
  if (!triangle.hasArea()) {
    return meet(triangle.segment(), other);
  }
  const auto& [a, b, c] = triangle.corners();
  return meet({a, b}, other) || meet({b, c}, other) || meet({c, a}, other);
}

/// Whether the side of `triangle` opposite to the shared corner intersects `other`. Only a triangle without area may
/// have its corner on that side.
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

/// Position of a point on the line of a segment: -1 before it, 0 on it, 1 after it.
int beyond(const Point& point, const Segment& segment) {
  const auto [first, last] = std::minmax(segment.from, segment.to, before);
  return before(point, first) ? -1 : before(last, point) ? 1 : 0;
}

}  // namespace

bool meet(const Facet& first, const Facet& second) {
  if (apart(first, second) || apart(second, first)) {
    return false;
  }
  // The intersection of two convex sets has a point on the boundary of one of them.
  return boundaryMeets(first, second) || boundaryMeets(second, first);
}

bool meetBeyondCorner(const Facet& first, const Facet& second) {
  if (apartExceptCorner(first, second) || apartExceptCorner(second, first)) {
    return false;
  }
  // Along a ray from the corner the intersection is a segment that starts at the corner and ends at the opposite side
  // of one of the triangles.
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

}  // namespace drape::intersection
