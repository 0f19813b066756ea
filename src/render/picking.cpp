#include "render/picking.hpp"

#include <array>

#include <Eigen/Geometry>

namespace drape::render {
namespace {

/// Where a ray meets one triangle, from either side (Moeller and Trumbore 1997).
std::optional<Hit> meet(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 normal = ray.direction.cross(ac);
  const double determinant = ab.dot(normal);
  // Written so that a NaN fails too. The bound only keeps out triangles without an area and rays in their plane.
  if (!(determinant * determinant > 1e-24 * ab.squaredNorm() * ac.squaredNorm())) {
    return std::nullopt;
  }
  const Vec3 fromA = ray.origin - a;
  const double weightB = fromA.dot(normal) / determinant;
  const Vec3 q = fromA.cross(ab);
  const double weightC = ray.direction.dot(q) / determinant;
  const double distance = ac.dot(q) / determinant;
  if (!(weightB >= 0.0 && weightC >= 0.0 && weightB + weightC <= 1.0 && distance > 0.0)) {
    return std::nullopt;
  }
  Hit hit;
  hit.barycentric = {1.0 - weightB - weightC, weightB, weightC};
  hit.point = ray.origin + distance * ray.direction;
  hit.distance = distance;
  return hit;
}

}  // namespace

std::optional<Hit> pick(const Ray& ray, std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  std::optional<Hit> nearest;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Triangle& corners = triangles[t];
    std::optional<Hit> hit = meet(ray, positions[corners[0]], positions[corners[1]], positions[corners[2]]);
    if (hit && (!nearest || hit->distance < nearest->distance)) {
      hit->triangle = static_cast<int>(t);
      nearest = hit;
    }
  }
  return nearest;
}

std::span<const fields::ScreenColour> pickColours() {
  // Far apart in hue and brightness, and unlike the ends of the colour maps.
  static constexpr std::array<fields::ScreenColour, 4> colours{
      {{1.00F, 0.55F, 0.10F}, {0.93F, 0.36F, 0.72F}, {0.36F, 0.78F, 0.98F}, {0.98F, 0.98F, 0.98F}}};
  return colours;
}

}  // namespace drape::render
