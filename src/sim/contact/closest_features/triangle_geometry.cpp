#include "sim/contact/closest_features/triangle_geometry.hpp"

namespace drape::sim::contact {

Vec3 onCorner(std::size_t k) {
  Vec3 weights = Vec3::Zero();
  weights[static_cast<Eigen::Index>(k)] = 1.0;
  return weights;
}

Vec3 onSide(std::size_t k, double along) {
  Vec3 weights = Vec3::Zero();
  weights[static_cast<Eigen::Index>(k)] = 1.0 - along;
  weights[static_cast<Eigen::Index>((k + 1) % 3)] = along;
  return weights;
}

Vec3 faceNormal(const Corners& corners) {
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double length = normal.norm();
  return length > 0.0 ? Vec3(normal / length) : Vec3(Vec3::UnitY());
}

}  // namespace drape::sim::contact
