#include "dressing/inside.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::dressing {
namespace {

/// The solid angle of a triangle from the origin (van Oosterom and Strackee 1983, eq. 8) [sr].
double solidAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  return 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

double windingNumber(const Vec3& point, std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  double sum = 0.0;
  for (const Triangle& t : triangles) {
    sum += solidAngle(positions[t[0]] - point, positions[t[1]] - point, positions[t[2]] - point);
  }
  return sum / (4.0 * std::numbers::pi);
}

}  // namespace

double shareInside(std::span<const Vec3> points, std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  constexpr std::size_t samples = 100;
  const std::size_t step = std::max<std::size_t>(1, points.size() / samples);
  std::size_t inside = 0;
  std::size_t tested = 0;
  for (std::size_t k = 0; k < points.size(); k += step) {
    ++tested;
    inside += windingNumber(points[k], positions, triangles) > 0.5 ? 1 : 0;
  }
  return tested > 0 ? static_cast<double>(inside) / static_cast<double>(tested) : 0.0;
}

}  // namespace drape::dressing
