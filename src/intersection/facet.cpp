#include "intersection/facet.hpp"

#include <algorithm>

namespace drape::intersection {
namespace {

using Point = Eigen::Vector3d;

constexpr std::array<Projection, 3> projections = {{{0, 1}, {1, 2}, {2, 0}}};

/// Whether the projections of two coplanar segments intersect; no value if all four projected points are collinear.
enum class Crossing { Yes, No, OnOneLine };

Crossing crossing(const Segment& a, const Segment& b, Projection p) {
  const int a0 = orientation(b.from, b.to, a.from, p);
  const int a1 = orientation(b.from, b.to, a.to, p);
  const int b0 = orientation(a.from, a.to, b.from, p);
  const int b1 = orientation(a.from, a.to, b.to, p);
  if (a0 == 0 && a1 == 0 && b0 == 0 && b1 == 0) {
    return Crossing::OnOneLine;
  }
  return a0 * a1 <= 0 && b0 * b1 <= 0 ? Crossing::Yes : Crossing::No;
}

bool overlapOnOneLine(const Segment& a, const Segment& b) {
  const auto [a0, a1] = std::minmax(a.from, a.to, before);
  const auto [b0, b1] = std::minmax(b.from, b.to, before);
  return !before(a1, b0) && !before(b1, a0);
}

/// Whether a segment in the plane of a triangle intersects it. It does not if one of the triangle's sides, or the line
/// of the segment, separates the two.
bool meetInPlane(const Segment& segment, const Facet& facet) {
  const auto& [a, b, c] = facet.corners();
  const Projection p = facet.projection();
  const int turn = orientation(a, b, c, p);
  const auto outside = [&](const Point& from, const Point& to) {
    return turn * orientation(from, to, segment.from, p) < 0 && turn * orientation(from, to, segment.to, p) < 0;
  };
  if (outside(a, b) || outside(b, c) || outside(c, a)) {
    return false;
  }
  const int sum = orientation(segment.from, segment.to, a, p) + orientation(segment.from, segment.to, b, p) +
                  orientation(segment.from, segment.to, c, p);
  return std::abs(sum) < 3;
}

}  // namespace

Facet::Facet(const Point& a, const Point& b, const Point& c) : corners_{a, b, c}, segment_{a, a} {
  for (const Projection& projection : projections) {
    if (orientation(a, b, c, projection) != 0) {
      projection_ = projection;
      hasArea_ = true;
      return;
    }
  }
  const auto [first, last] = std::minmax({a, b, c}, before);
  segment_ = {first, last};
}

bool meet(const Segment& a, const Segment& b) {
  if (orientation(a.from, a.to, b.from, b.to) != 0) {
    return false;
  }
  for (const Projection& projection : projections) {
    const Crossing found = crossing(a, b, projection);
    if (found != Crossing::OnOneLine) {
      return found == Crossing::Yes;
    }
  }
  return overlapOnOneLine(a, b);
}

bool meet(const Segment& segment, const Facet& facet) {
  if (!facet.hasArea()) {
    return meet(segment, facet.segment());
  }
  const int from = facet.sideOf(segment.from);
  const int to = facet.sideOf(segment.to);
  if (from * to > 0) {
    return false;
  }
  if (from == 0 && to == 0) {
    return meetInPlane(segment, facet);
  }
  return isPassedByLine(facet.corners(), segment.from, segment.to);
}

bool before(const Point& a, const Point& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

bool collinear(const Point& a, const Point& b, const Point& c) {
  return std::all_of(projections.begin(), projections.end(),
                     [&](Projection projection) { return orientation(a, b, c, projection) == 0; });
}

}  // namespace drape::intersection
