#include "ui/wind_mapping.hpp"

#include <algorithm>
#include <cmath>

namespace drape::ui {

Vec2 dialOffset(const Vec3& wind) {
  const Vec2 level(wind.x(), wind.z());
  const double speed = level.norm();
  if (speed == 0.0) {
    return Vec2::Zero();
  }
  return level / speed * std::min(1.0, std::sqrt(speed / dialSpeed));
}

Vec3 windFromDial(const Vec2& offset) {
  const double radius = offset.norm();
  if (radius == 0.0) {
    return Vec3::Zero();
  }
  const double reach = std::min(radius, 1.0);
  const Vec2 level = offset / radius * (reach * reach * dialSpeed);
  const auto rounded = [](double value) { return std::round(value * 100.0) / 100.0; };
  return {rounded(level.x()), 0.0, rounded(level.y())};
}

}  // namespace drape::ui
