#pragma once

#include "intersection/orientation.hpp"

#include <array>

namespace drape {

/// Two points and all between them; one point when they are equal.
struct Segment {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
};

/// A triangle as what it is: where its corners lie on one line it is a segment or a point, and treated as such.
class Facet {
 public:
  Facet(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

  [[nodiscard]] const std::array<Eigen::Vector3d, 3>& corners() const { return corners_; }
  /// True when the triangle has an area.
  [[nodiscard]] bool hasArea() const { return hasArea_; }
  /// A projection in which the triangle keeps an area, when it has one.
  [[nodiscard]] Projection projection() const { return projection_; }
  /// All of the triangle, when it has no area.
  [[nodiscard]] const Segment& segment() const { return segment_; }

  /// On which side of the triangle's plane a point lies: 1, 0 (in it) or -1. Needs an area.
  [[nodiscard]] int sideOf(const Eigen::Vector3d& point) const {
    return orientation(corners_[0], corners_[1], corners_[2], point);
  }

 private:
  std::array<Eigen::Vector3d, 3> corners_;
  Projection projection_;
  bool hasArea_ = false;
  Segment segment_;
};

/// Whether two closed segments have a point in common.
[[nodiscard]] bool meet(const Segment& a, const Segment& b);

/// Whether a closed segment and a closed triangle have a point in common.
[[nodiscard]] bool meet(const Segment& segment, const Facet& facet);

/// The order of points along any line: by x, then y, then z.
[[nodiscard]] bool before(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Whether three points lie on one line.
[[nodiscard]] bool collinear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

}  // namespace drape
