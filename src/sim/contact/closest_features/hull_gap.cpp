#include "sim/contact/closest_features/hull_gap.hpp"

#include "sim/contact/closest_features/closest_points.hpp"

#include <algorithm>

namespace drape::sim::contact {
namespace {

constexpr int maxGjkIterations = 16;
constexpr double gapTolerance = 0.95;  // a gap of this fraction of the present distance of the hulls suffices [-]
constexpr double touching = 1e-9;      // distances below this count as zero [m]

/// The point of a triangle, edge or vertex that is closest to the origin, and the corners with non-zero weights.
struct Nearest {
  Vec3 point = Vec3::Zero();
  std::array<bool, 3> uses{};
};

Nearest nearestToOrigin(const Corners& corners) {
  const Vec3 weights = quickNearestOnTriangle(Vec3::Zero(), corners[0], corners[1], corners[2]);
  return {pointAt(corners, weights), {weights[0] > 0.0, weights[1] > 0.0, weights[2] > 0.0}};
}

/// Whether the origin is inside a tetrahedron.
bool holdsOrigin(const std::array<Vec3, 4>& corners) {
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3& from = corners[(k + 1) % 4];
    const Vec3 normal = (corners[(k + 2) % 4] - from).cross(corners[(k + 3) % 4] - from);
    if (!(normal.dot(-from) * normal.dot(corners[k] - from) > 0.0)) {
      return false;
    }
  }
  return true;
}

}  // namespace

/// Measures the gap along a direction, and stores it if it is the widest so far. Finds the support point of the cloth.
/// @return the support point of the leaves
SupportPoint HullGapSearch::measure(const Vec3& along) {
  SupportPoint far = mesh_.supportPoint(along, leaves_, atEnd_);
  lowest_ = 0;
  double low = along.dot(points_[0]);
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const double height = along.dot(points_[i]);
    if (height < low) {
      low = height;
      lowest_ = i;
    }
  }
  if (low - far.height > best_.atLeast) {
    best_ = {low - far.height, along, far.height};
  }
  return far;
}

/// Reduces the simplex to the feature that is closest to the origin; false if the origin is inside.
bool HullGapSearch::reduce() {
  const std::array<Vec3, 4> all = simplex_;
  const std::size_t count = count_;
  double minimum = std::numeric_limits<double>::infinity();
  const auto offer = [&](const std::array<std::size_t, 3>& of) {
    const Nearest nearest = nearestToOrigin({all[of[0]], all[of[1]], all[of[2]]});
    const double distance = nearest.point.squaredNorm();
    if (distance >= minimum) {
      return;
    }
    minimum = distance;
    offset_ = nearest.point;
    count_ = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (nearest.uses[k]) {
        simplex_[count_++] = all[of[k]];
      }
    }
  };
  if (count == 4) {
    if (holdsOrigin(all)) {
      return false;
    }
    // The last corner is new. The face of the other three was the closest one before.
    offer({0, 1, 3});
    offer({1, 2, 3});
    offer({2, 0, 3});
  } else {
    offer({0, std::min<std::size_t>(1, count - 1), count - 1});
  }
  return offset_.norm() > touching;
}

HullGap HullGapSearch::search(const Vec3& along, const Wanted& wanted) {
  SupportPoint far = measure(along);
  // Usually the points are the corners of a triangle and the direction is its normal, so all are support points.
  count_ = std::min<std::size_t>(points_.size(), 3);
  for (std::size_t i = 0; i < count_; ++i) {
    simplex_[i] = points_[i] - far.point;
  }
  for (int iteration = 0; iteration < maxGjkIterations && best_.atLeast < wanted.gap && reduce(); ++iteration) {
    const double distance = offset_.norm();
    const bool isLess = distance < wanted.gap;
    if (isLess && (best_.atLeast >= wanted.minimum || distance < wanted.minimum)) {
      break;
    }
    if (best_.atLeast >= gapTolerance * distance) {
      break;
    }
    far = measure(offset_ / distance);
    const Vec3 next = points_[lowest_] - far.point;
    if (offset_.dot(offset_ - next) <= touching * distance) {
      break;  // no point is closer
    }
    simplex_[count_++] = next;
  }
  return best_;
}

}  // namespace drape::sim::contact
