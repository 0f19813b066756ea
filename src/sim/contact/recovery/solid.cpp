#include "sim/contact/recovery/solid.hpp"

#include "sim/contact/closest_features/closest_points.hpp"

#include <algorithm>
#include <limits>

namespace drape::sim::contact {

bool MeshSolid::contains(const Vec3& point) {
  if (!mesh_.mesh.tree.bounds().contains(point)) {
    return false;
  }
  // Not along axes or diagonals, which are parallel to edges of many meshes.
  static const std::array<Vec3, 3> directions{Vec3(0.36, 0.48, 0.8), Vec3(-0.48, 0.64, -0.6), Vec3(0.8, -0.36, 0.48)};
  int votes = 0;
  for (int i = 0; i < 3; ++i) {
    crossingsAlong(mesh_, point, directions[i], crossings_);
    votes += windingOf(crossings_) > 0 ? 1 : 0;
    if (i > 0 && votes != 1) {
      break;
    }
  }
  return votes > 1;
}

NearestMeshPoint MeshSolid::nearestTo(const Vec3& point) {
  double radius = std::numeric_limits<double>::infinity();
  if (last_.triangle >= 0) {
    constexpr double more = 1.0 + 1e-9;  // so that the point itself is within the radius
    radius = more * (pointAt(mesh_.corners(last_.triangle), last_.weights) - point).norm() + 1e-12;
  }
  NearestMeshPoint found = nearest_.anywhere(point, radius);
  last_ = found.triangle < 0 ? last_ : found;
  return found;
}

NearPoint MeshSolid::nearestExit(const Vec3& point) {
  const NearestMeshPoint found = nearestTo(point);
  if (found.triangle < 0) {
    return {};
  }
  const Vec3 normal = found.gap > 0.0 ? Vec3(-found.normal) : faceNormal(mesh_.corners(found.triangle));
  return {-found.gap, normal, pointAt(mesh_.startCorners(found.triangle), found.weights),
          pointAt(mesh_.endCorners(found.triangle), found.weights)};
}

NearPoint MeshSolid::nearestSurface(const Vec3& point) {
  const NearestMeshPoint found = nearestTo(point);
  return found.triangle < 0 ? NearPoint() : pointOf(mesh_, found);
}

void MeshSolid::findCrossings(const Vec3& point, const Vec3& direction) {
  crossingsAlong(mesh_, point, direction, crossings_);
  std::stable_sort(crossings_.begin(), crossings_.end(),
                   [](const Crossing& a, const Crossing& b) { return a.distance < b.distance; });
}

NearPoint MeshSolid::exitAt(const Crossing& crossing, const Vec3& direction) const {
  return {-crossing.distance, direction, pointAt(mesh_.startCorners(crossing.triangle), crossing.weights),
          pointAt(mesh_.endCorners(crossing.triangle), crossing.weights)};
}

NearPoint MeshSolid::exitAlong(const Vec3& point, const Vec3& direction) {
  findCrossings(point, direction);
  int level = windingOf(crossings_);
  for (const Crossing& crossing : crossings_) {
    level -= crossing.outwards ? 1 : -1;
    if (level <= 0) {
      return exitAt(crossing, direction);
    }
  }
  return nearestExit(point);  // it is on the surface, within the rounding error
}

std::optional<Passage> MeshSolid::passageAlong(const Vec3& point, const Vec3& direction) {
  findCrossings(point, direction);
  int level = 0;
  double enter = 0.0;
  for (const Crossing& crossing : crossings_) {
    const int before = level;
    level += crossing.outwards ? -1 : 1;
    if (before == 0 && level == 1) {
      enter = crossing.distance;
    } else if (before == 1 && level == 0) {
      return Passage{enter, exitAt(crossing, direction)};
    }
  }
  return std::nullopt;
}

Vec3 CapsuleSolid::fromCore(const Vec3& point) const {
  return point - core_[0] - nearestOnSegment(point, core_[0], core_[1]) * (core_[1] - core_[0]);
}

bool CapsuleSolid::contains(const Vec3& point) {
  return fromCore(point).norm() < radius_;
}

NearPoint CapsuleSolid::nearestExit(const Vec3& point) {
  const Vec3 offset = fromCore(point);
  const double distance = offset.norm();
  const Vec3 axis = core_[1] - core_[0];
  const Vec3 aside = axis.isZero(0.0) ? Vec3(Vec3::UnitY()) : Vec3(axis.unitOrthogonal());
  const Vec3 normal = distance > 0.0 ? Vec3(offset / distance) : aside;
  const Vec3 exit = point + (radius_ - distance) * normal;
  return {distance - radius_, normal, exit, exit};
}

double CapsuleSolid::surfaceBetween(const Vec3& point, const Vec3& direction, double in, double out) {
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (in + out);
    (contains(point + middle * direction) ? in : out) = middle;
  }
  return out;
}

NearPoint CapsuleSolid::exitAlong(const Vec3& point, const Vec3& direction) {
  const double farther = 2.0 * radius_ + (core_[1] - core_[0]).norm();
  const double out = surfaceBetween(point, direction, 0.0, farther);
  const Vec3 exit = point + out * direction;
  return {-out, direction, exit, exit};
}

std::optional<Passage> CapsuleSolid::passageAlong(const Vec3& point, const Vec3& direction) {
  const double farther = fromCore(point).norm() + 2.0 * radius_ + 2.0 * (core_[1] - core_[0]).norm();
  const double nearest = farther * nearestOfSegments({point, point + farther * direction}, core_).first;
  if (!contains(point + nearest * direction)) {
    return std::nullopt;
  }
  const double enter = surfaceBetween(point, direction, nearest, 0.0);
  const double out = surfaceBetween(point, direction, nearest, farther);
  const Vec3 exit = point + out * direction;
  return Passage{enter, {-out, direction, exit, exit}};
}

}  // namespace drape::sim::contact
