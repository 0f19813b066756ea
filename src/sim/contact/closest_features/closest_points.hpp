#pragma once

#include "sim/contact/closest_features/triangle_geometry.hpp"

#include <array>

namespace drape::sim::contact {

/// The barycentric coordinates of the point of a triangle that is closest to `point`; at least one is zero if it lies
/// on the border. A triangle that is a sliver is treated as its three sides.
[[nodiscard]] Vec3 nearestOnTriangle(const Vec3& point, const Corners& triangle);

/// The same for the triangle a, b, c, by Voronoi regions (Ericson 2005, Real-Time Collision Detection, sec. 5.1.5).
/// Faster, but inaccurate for slivers.
[[nodiscard]] Vec3 quickNearestOnTriangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c);

/// The parameter of the point of a segment from a (0) to b (1) that is closest to `point`.
[[nodiscard]] double nearestOnSegment(const Vec3& point, const Vec3& a, const Vec3& b);

/// The closest points of two segments, as parameters from 0 to 1. For parallel segments one of many closest pairs.
struct SegmentPair {
  double first = 0.0;
  double second = 0.0;
};
[[nodiscard]] SegmentPair nearestOfSegments(const std::array<Vec3, 2>& first, const std::array<Vec3, 2>& second);

/// The closest points of a triangle and a segment.
struct TriangleSegmentPair {
  Vec3 weights = Vec3::Zero();  ///< of the triangle's corners
  double along = 0.0;           ///< parameter on the segment, 0 to 1
};
[[nodiscard]] TriangleSegmentPair nearestOfTriangleAndSegment(const Corners& triangle,
                                                              const std::array<Vec3, 2>& segment);

/// The distance of two triangles and the normal of a separating plane.
struct TriangleGap {
  double distance = 0.0;             ///< along the normal, at most that of the triangles [m]; 0 or less: none was found
  Vec3 normal = Vec3::UnitY();       ///< from the second to the first
  Vec3 firstWeights = Vec3::Zero();  ///< of the closest point of the first triangle
  Vec3 secondWeights = Vec3::Zero();  ///< of the closest point of the second triangle
};

/// Compares the 15 pairs of features: 6 of a corner and a face, 9 of two sides. If the normal of the closest points
/// does not separate the triangles, because of rounding at slivers, it takes the widest gap along the axes of the
/// separating axis theorem.
[[nodiscard]] TriangleGap gapOfTriangles(const Corners& first, const Corners& second);

}  // namespace drape::sim::contact
