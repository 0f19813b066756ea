#pragma once

#include "intersection/orientation.hpp"

#include <array>

namespace drape::intersection {

/// A segment; a point if both ends are equal.
struct Segment {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
};

/// A triangle. If its corners are collinear, it is treated as a segment or a point.
class Facet {
 public:
  Facet(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

  [[nodiscard]] const std::array<Eigen::Vector3d, 3>& corners() const { return corners_; }
  /// Whether the triangle has an area.
  [[nodiscard]] bool hasArea() const { return hasArea_; }
  /// A projection in which the triangle has an area, if it has one.
  [[nodiscard]] Projection projection() const { return projection_; }
  /// The whole triangle, if it has no area.
  [[nodiscard]] const Segment& segment() const { return segment_; }

  /// The side of the triangle's plane on which a point lies: 1, 0 (in the plane) or -1. Requires an area.
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

/// Lexicographic order by x, y, z, which orders the points of any line.
[[nodiscard]] bool before(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Whether three points are collinear.
[[nodiscard]] bool collinear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

}  // namespace drape::intersection
