#pragma once

#include <Eigen/Core>
#include <array>

namespace drape::intersection {

/// The exact sign of the volume that b - a, c - a and d - a span: 1 if d lies on the side of the plane a, b, c from
/// which these are in counter-clockwise order, -1 on the other side, 0 if and only if the four points are coplanar. A
/// bound of the rounding error (Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates, 1997) decides most cases. The others are computed with integers, of 128 bits or, if necessary, of any
/// length (GMP). The coordinates must be finite.
[[nodiscard]] int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                              const Eigen::Vector3d& d);

/// Whether a line through a triangle's plane passes through the triangle, or touches its border. Exact.
/// @param from, to two points of the line on different sides of the plane, or one of them in it
[[nodiscard]] bool isPassedByLine(const std::array<Eigen::Vector3d, 3>& triangle, const Eigen::Vector3d& from,
                                  const Eigen::Vector3d& to);

/// A projection along a coordinate axis: the two coordinates that remain.
struct Projection {
  int u = 0;
  int v = 1;
};

/// The exact sign of the area that b - a and c - a span in a projection: 1 if a, b, c turn from u towards v, 0 if and
/// only if they are collinear there.
[[nodiscard]] int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                              Projection projection);

}  // namespace drape::intersection
