#include "scene/framing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape {

CameraPose framed(const CameraPose& pose, const Vec3& min, const Vec3& max, double aspect) {
  constexpr double margin = 1.1;
  const double radius = std::max(0.5 * (max - min).norm(), 1e-3);
  const double halfAngle = 0.5 * pose.viewAngle * std::numbers::pi / 180.0;
  const double narrowest = std::min(halfAngle, std::atan(std::tan(halfAngle) * aspect));
  Vec3 direction = pose.position - pose.focalPoint;
  direction = direction.norm() > 0.0 ? Vec3(direction.normalized()) : Vec3(Vec3::UnitZ());
  CameraPose result = pose;
  result.focalPoint = 0.5 * (min + max);
  result.position = result.focalPoint + direction * (margin * radius / std::sin(narrowest));
  return result;
}

}  // namespace drape
