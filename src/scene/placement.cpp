#include "scene/placement.hpp"

#include "sim/contact/bodies/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::scene {
namespace {

constexpr double radiansPerDegree = std::numbers::pi / 180.0;

double rounded(double value) {
  constexpr double places = 1e6;
  return std::round(value * places) / places + 0.0;  // not -0
}

Vec3 rounded(const Vec3& value) {
  return {rounded(value.x()), rounded(value.y()), rounded(value.z())};
}

/// Axis times angle [degrees].
Vec3 degreesOf(const Eigen::Quaterniond& rotation) {
  const Eigen::AngleAxisd turn(rotation.normalized());
  return turn.angle() / radiansPerDegree * turn.axis();
}

}  // namespace

bool Placement::isNone() const {
  return *this == Placement();
}

sim::contact::Pose Placement::pose() const {
  return sim::contact::poseOf(position, radiansPerDegree * rotation);
}

std::vector<Vec3> Placement::applied(std::vector<Vec3> points) const {
  if (isNone()) {
    return points;
  }
  const sim::contact::Pose own = pose();
  for (Vec3& point : points) {
    point = own.toWorld(scale * point);
  }
  return points;
}

Placement movedTo(const Placement& placement, const Vec3& point, const Vec3& place) {
  Placement moved = placement;
  moved.position.setZero();
  moved.position = rounded(Vec3(place - moved.applied(point)));
  return moved;
}

Placement withRotation(const Placement& placement, const Vec3& point, const Vec3& degrees) {
  Placement turned = placement;
  turned.rotation = rounded(degrees);
  return movedTo(turned, point, placement.applied(point));
}

Placement turnedAbout(const Placement& placement, const Vec3& point, const Eigen::Quaterniond& rotation) {
  return withRotation(placement, point, degreesOf(rotation * placement.pose().rotation));
}

Placement scaledAbout(const Placement& placement, const Vec3& point, double scale) {
  Placement scaled = placement;
  scaled.scale = std::clamp(rounded(scale), minPlacementScale, maxPlacementScale);
  return movedTo(scaled, point, placement.applied(point));
}

}  // namespace drape::scene
