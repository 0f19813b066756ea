#include "sim/contact/closest_features/closest_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape::sim::contact {
namespace {

constexpr std::array<std::array<int, 2>, 3> sides{{{0, 1}, {1, 2}, {2, 0}}};

const Vec3& at(const Corners& corners, int i) {
  return corners[i];
}

Vec3 onSide(const std::array<int, 2>& side, double along) {
  Vec3 weights = Vec3::Zero();
  weights[side[0]] = 1.0 - along;
  weights[side[1]] = along;
  return weights;
}

Vec3 nearestOnBorder(const Vec3& point, const Corners& triangle) {
  double best = std::numeric_limits<double>::infinity();
  Vec3 weights = Vec3::UnitX();
  for (const auto& side : sides) {
    const Vec3& a = at(triangle, side[0]);
    const Vec3& b = at(triangle, side[1]);
    const double along = nearestOnSegment(point, a, b);
    const double distance = (a + along * (b - a) - point).squaredNorm();
    if (distance < best) {
      best = distance;
      weights = onSide(side, along);
    }
  }
  return weights;
}

/// Gap between the projections of two triangles onto a unit vector [m]; negative: they overlap.
double separationAlong(const Vec3& normal, const Corners& first, const Corners& second) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < 3; ++i) {
    low = std::min(low, normal.dot(first[i] - second[0]));
    high = std::max(high, normal.dot(second[i] - second[0]));
  }
  return low - high;
}

/// Takes the widest gap among the separating axes: the normals of the faces and the cross products of pairs of edges
/// (separating axis theorem).
void tryOtherPlanes(const Corners& first, const Corners& second, TriangleGap& gap) {
  const auto offer = [&](const Vec3& axis) {
    const double length = axis.norm();
    for (const double sign : {1.0, -1.0}) {
      const Vec3 normal = sign / length * axis;
      const double distance = separationAlong(normal, first, second);
      if (length > 0.0 && distance > gap.distance) {
        gap.distance = distance;
        gap.normal = normal;
      }
    }
  };
  offer((first[1] - first[0]).cross(first[2] - first[0]));
  offer((second[1] - second[0]).cross(second[2] - second[0]));
  for (const auto& a : sides) {
    for (const auto& b : sides) {
      offer((at(first, a[1]) - at(first, a[0])).cross(at(second, b[1]) - at(second, b[0])));
    }
  }
}

}  // namespace

double nearestOnSegment(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 direction = b - a;
  const double length = direction.squaredNorm();
  return length > 0.0 ? std::clamp((point - a).dot(direction) / length, 0.0, 1.0) : 0.0;
}

Vec3 nearestOnTriangle(const Vec3& point, const Corners& triangle) {
  const Vec3 ab = triangle[1] - triangle[0];
  const Vec3 ac = triangle[2] - triangle[0];
  const Vec3 normal = ab.cross(ac);
  const double area = normal.squaredNorm();
  // A sliver is treated as its border, since rounding spoils its normal. The comparison sends NaN there too.
  constexpr double thin = 1e-14;  // squared sine of the angle between two sides
  if (area > thin * ab.squaredNorm() * ac.squaredNorm()) {
    const Vec3 ap = point - triangle[0];
    const double c = ab.cross(ap).dot(normal) / area;
    const double b = ap.cross(ac).dot(normal) / area;
    if (b >= 0.0 && c >= 0.0 && b + c <= 1.0) {
      return {1.0 - b - c, b, c};
    }
  }
  return nearestOnBorder(point, triangle);
}

Vec3 quickNearestOnTriangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ap = point - a;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) {
    return {1.0, 0.0, 0.0};
  }
  const Vec3 bp = point - b;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) {
    return {0.0, 1.0, 0.0};
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double along = d1 / (d1 - d3);
    return {1.0 - along, along, 0.0};
  }
  const Vec3 cp = point - c;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) {
    return {0.0, 0.0, 1.0};
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double along = d2 / (d2 - d6);
    return {1.0 - along, 0.0, along};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double along = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0.0, 1.0 - along, along};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

SegmentPair nearestOfSegments(const std::array<Vec3, 2>& first, const std::array<Vec3, 2>& second) {
  const Vec3 d1 = first[1] - first[0];
  const Vec3 d2 = second[1] - second[0];
  const Vec3 between = first[0] - second[0];
  const double a = d1.squaredNorm();
  const double e = d2.squaredNorm();
  const double b = d1.dot(d2);
  const double determinant = a * e - b * b;
  SegmentPair pair;
  // Minimises over the line of the first segment, then clamps alternately. Parallel segments start at parameter 0.
  if (determinant > 1e-14 * a * e) {
    pair.first = std::clamp((b * d2.dot(between) - e * d1.dot(between)) / determinant, 0.0, 1.0);
  }
  pair.second = nearestOnSegment(first[0] + pair.first * d1, second[0], second[1]);
  pair.first = nearestOnSegment(second[0] + pair.second * d2, first[0], first[1]);
  return pair;
}

TriangleSegmentPair nearestOfTriangleAndSegment(const Corners& triangle, const std::array<Vec3, 2>& segment) {
  // Start with the point where the segment pierces the triangle.
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double from = (segment[0] - triangle[0]).dot(normal);
  const double to = (segment[1] - triangle[0]).dot(normal);
  TriangleSegmentPair best;
  double minimum = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Vec3& weights, double along) {
    const double distance = (pointAt(triangle, weights) - segment[0] - along * (segment[1] - segment[0])).squaredNorm();
    if (distance < minimum) {
      minimum = distance;
      best = {weights, along};
    }
  };
  if (from * to < 0.0) {
    const double along = from / (from - to);
    offer(nearestOnTriangle(segment[0] + along * (segment[1] - segment[0]), triangle), along);
  }
  offer(nearestOnTriangle(segment[0], triangle), 0.0);
  offer(nearestOnTriangle(segment[1], triangle), 1.0);
  for (const auto& side : sides) {
    const SegmentPair pair = nearestOfSegments({at(triangle, side[0]), at(triangle, side[1])}, segment);
    offer(onSide(side, pair.first), pair.second);
  }
  return best;
}

TriangleGap gapOfTriangles(const Corners& first, const Corners& second) {
  TriangleGap gap;
  double minimum = std::numeric_limits<double>::infinity();
  Vec3 offset = Vec3::Zero();
  const auto offer = [&](const Vec3& firstWeights, const Vec3& secondWeights) {
    const Vec3 between = pointAt(first, firstWeights) - pointAt(second, secondWeights);
    if (between.squaredNorm() < minimum) {
      minimum = between.squaredNorm();
      offset = between;
      gap.firstWeights = firstWeights;
      gap.secondWeights = secondWeights;
    }
  };
  for (int i = 0; i < 3; ++i) {
    offer(onSide({i, i}, 1.0), nearestOnTriangle(at(first, i), second));
    offer(nearestOnTriangle(at(second, i), first), onSide({i, i}, 1.0));
  }
  for (const auto& a : sides) {
    for (const auto& b : sides) {
      const SegmentPair pair =
          nearestOfSegments({at(first, a[0]), at(first, a[1])}, {at(second, b[0]), at(second, b[1])});
      offer(onSide(a, pair.first), onSide(b, pair.second));
    }
  }
  gap.distance = std::sqrt(minimum);
  if (!(gap.distance > 0.0)) {
    gap.distance = 0.0;
    return gap;
  }
  gap.normal = offset / gap.distance;
  // The closest points of disjoint convex shapes define a separating plane; those of intersecting triangles do not. For
  // slivers the closest points can be so inaccurate that another plane is needed.
  gap.distance = separationAlong(gap.normal, first, second);
  if (!(gap.distance > 0.0)) {
    tryOtherPlanes(first, second, gap);
  }
  return gap;
}

}  // namespace drape::sim::contact
