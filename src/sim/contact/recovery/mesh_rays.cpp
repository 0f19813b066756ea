#include "sim/contact/recovery/mesh_rays.hpp"

#include <Eigen/Geometry>
#include <utility>

namespace drape::sim::contact {
namespace {

using Vec2 = Eigen::Vector2d;

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// On which side of the line from a to b the origin lies: 1 or -1. If it lies on the line, it counts as moved by (e,
/// e^2) with an infinitesimal e. 0 if a equals b. Exactly antisymmetric in a and b.
int sideOf(const Vec2& a, const Vec2& b) {
  for (const double each : {cross(a, b), a.y() - b.y(), b.x() - a.x()}) {
    if (each != 0.0) {
      return each > 0.0 ? 1 : -1;
    }
  }
  return 0;
}

/// A ray with a coordinate system of the plane normal to it.
class Ray {
 public:
  Ray(Vec3 from, const Vec3& direction)
      : from_(std::move(from)), direction_(direction), u_(direction.unitOrthogonal()), v_(direction.cross(u_)) {}

  /// Whether it passes through a triangle in front of its origin.
  bool meets(const Corners& corners, Crossing& crossing) const {
    const std::array<Vec2, 3> at{across(corners[0]), across(corners[1]), across(corners[2])};
    const int side = sideOf(at[0], at[1]);
    if (side == 0 || sideOf(at[1], at[2]) != side || sideOf(at[2], at[0]) != side) {
      return false;
    }
    Vec3 weights(cross(at[1], at[2]), cross(at[2], at[0]), cross(at[0], at[1]));
    const double sum = weights.sum();
    weights = sum != 0.0 ? Vec3(weights / sum) : Vec3(Vec3::Constant(1.0 / 3.0));
    crossing.distance = direction_.dot(pointAt(corners, weights) - from_);
    crossing.weights = weights;
    crossing.outwards = side > 0;
    return crossing.distance > 0.0;
  }

 private:
  [[nodiscard]] Vec2 across(const Vec3& point) const {
    const Vec3 offset = point - from_;
    return {u_.dot(offset), v_.dot(offset)};
  }

  Vec3 from_, direction_, u_, v_;
};

}  // namespace

void crossingsAlong(const MeshInStep& mesh, const Vec3& from, const Vec3& direction, std::vector<Crossing>& crossings) {
  crossings.clear();
  const Ray ray(from, direction);
  mesh.mesh.tree.forEachLeafAlong(from, direction, [&](std::size_t leaf) {
    for (const int triangle : mesh.mesh.tree.leaf(leaf)) {
      Crossing crossing;
      if (ray.meets(mesh.corners(triangle), crossing)) {
        crossing.triangle = triangle;
        crossings.push_back(crossing);
      }
    }
  });
}

int windingOf(const std::vector<Crossing>& crossings) {
  int winding = 0;
  for (const Crossing& crossing : crossings) {
    winding += crossing.outwards ? 1 : -1;
  }
  return winding;
}

}  // namespace drape::sim::contact
