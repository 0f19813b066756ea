#include "scene/framing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::scene {

Vec3 viewOffset(const CameraPose& pose) {
  const Vec3 offset = pose.position - pose.focalPoint;
  return offset.norm() > 1e-9 ? offset : Vec3(0.0, 0.0, 1.0);
}

CameraBasis basisOf(const CameraPose& pose) {
  CameraBasis basis;
  basis.back = viewOffset(pose).normalized();
  // For a view straight down or up, x stays to the right.
  const Vec3 side = Vec3::UnitY().cross(basis.back);
  basis.right = side.norm() > 1e-9 ? side.normalized() : Vec3(Vec3::UnitX());
  basis.up = basis.back.cross(basis.right);
  return basis;
}

double tanHalfAngle(const CameraPose& pose) {
  return std::tan(0.5 * pose.viewAngle * std::numbers::pi / 180.0);
}

bool isFarEnough(const CameraPose& pose) {
  constexpr double rounding = 1e-9;
  return (pose.position - pose.focalPoint).norm() >= (1.0 - rounding) * minViewDistance;
}

CameraPose framed(const CameraPose& pose, const Vec3& min, const Vec3& max, double aspect) {
  constexpr double margin = 1.12;
  constexpr double smallestSize = 0.02;  // [m] size of the view of a single point
  const CameraBasis basis = basisOf(pose);
  const Vec3 half = (0.5 * margin * (max - min)).cwiseMax(0.5 * smallestSize);
  const double slopeUp = tanHalfAngle(pose);
  const double slopeRight = slopeUp * aspect;
  double distance = minViewDistance;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0, (corner & 4) != 0 ? 1.0 : -1.0);
    const Vec3 offset = half.cwiseProduct(sign);
    const double spread =
        std::max(std::abs(offset.dot(basis.right)) / slopeRight, std::abs(offset.dot(basis.up)) / slopeUp);
    distance = std::max(distance, offset.dot(basis.back) + spread);
  }
  CameraPose result = pose;
  result.focalPoint = 0.5 * (min + max);
  result.position = result.focalPoint + std::min(distance, maxViewDistance) * basis.back;
  return result;
}

}  // namespace drape::scene
