#pragma once

#include "sim/contact/closest_features/triangle_geometry.hpp"

#include <array>

namespace drape {

/// The weights of the corners at the point of a triangle that is nearest to `point`; at least one is zero when it lies
/// on the triangle's border. Triangles without area are treated as the segments that they are.
[[nodiscard]] Vec3 nearestOnTriangle(const Vec3& point, const Corners& triangle);

/// The same by the regions of its corners, sides and inside (Ericson 2005, Real-Time Collision Detection, sec. 5.1.5).
/// Of slivers it may be a point that is not quite the nearest.
[[nodiscard]] Vec3 quickNearestOnTriangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c);

/// Where on the segment from a to b the point nearest to `point` is: 0 at a, 1 at b.
[[nodiscard]] double nearestOnSegment(const Vec3& point, const Vec3& a, const Vec3& b);

/// The nearest points of two segments, each from 0 at its first end to 1 at its second. Where segments are parallel
/// many pairs are as near; one of them is given back.
struct SegmentPair {
  double first = 0.0;
  double second = 0.0;
};
[[nodiscard]] SegmentPair nearestOfSegments(const std::array<Vec3, 2>& first, const std::array<Vec3, 2>& second);

/// The nearest points of a triangle and a segment.
struct TriangleSegmentPair {
  Vec3 weights = Vec3::Zero();  ///< of the triangle's corners
  double along = 0.0;           ///< the segment, from 0 to 1
};
[[nodiscard]] TriangleSegmentPair nearestOfTriangleAndSegment(const Corners& triangle,
                                                              const std::array<Vec3, 2>& segment);

/// How far two triangles are from each other, and a plane between them.
struct TriangleGap {
  double distance = 0.0;              ///< [m]; 0 or less: they intersect
  Vec3 normal = Vec3::UnitY();        ///< from the second to the first
  Vec3 firstWeights = Vec3::Zero();   ///< of the corners at the first triangle's nearest point
  Vec3 secondWeights = Vec3::Zero();  ///< the same of the second
};
[[nodiscard]] TriangleGap gapOfTriangles(const Corners& first, const Corners& second);

}  // namespace drape
