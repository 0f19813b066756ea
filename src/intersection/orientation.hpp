#pragma once

#include <Eigen/Core>

namespace drape {

/// The sign of the volume that b - a, c - a and d - a span, without any rounding: 1 when d lies on the side of the
/// plane a, b, c from which these turn counter-clockwise, -1 on the other side, 0 exactly when the four points lie in
/// one plane. A bound on the rounding error (after Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast
/// Robust Geometric Predicates, 1997) settles nearly all; the rest is computed in whole numbers, of 128 bits or, where
/// that is not enough, of any length (GMP). The coordinates must be finite.
[[nodiscard]] int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                              const Eigen::Vector3d& d);

/// A projection along a coordinate axis: the two coordinates that remain.
struct Projection {
  int u = 0;
  int v = 1;
};

/// The sign of the area that b - a and c - a span in a projection, without any rounding: 1 when a, b, c turn from u
/// towards v, 0 exactly when they lie on a line there.
[[nodiscard]] int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                              Projection projection);

}  // namespace drape
