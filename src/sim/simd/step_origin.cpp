#include "sim/simd/step_origin.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace drape::sim::simd {
namespace {

/// Vertices from which the middle is estimated. All of them would cost a noticeable part of a step.
constexpr std::size_t samples = 16;

/// Positions beyond it belong to a simulation that diverges [m].
constexpr double maxCoordinate = 1e8;

}  // namespace

template <>
Vec3 stepOrigin<float>(std::span<const Vec3> positions) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < positions.size(); i += 1 + positions.size() / samples) {
    if (!(positions[i].cwiseAbs().maxCoeff() < maxCoordinate)) {
      return Vec3::Zero();
    }
    box.extend(positions[i]);
  }
  const double size = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
  if (!(size > 0.0)) {
    return Vec3::Zero();
  }
  const double spacing = std::ldexp(1.0, std::ilogb(size) - 2);
  return spacing * ((box.center() / spacing).array() + 0.5).floor().matrix();
}

template <>
Vec3 stepOrigin<double>(std::span<const Vec3> /*positions*/) {
  return Vec3::Zero();
}

}  // namespace drape::sim::simd
