#include "render/surface_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace drape::render {
namespace {

using Lanes = SurfaceShapes::Lanes;

/// Cross product of the first three components; the fourth stays zero.
Lanes cross(Lanes a, Lanes b) {
  const Lanes aYzx = __builtin_shufflevector(a, a, 1, 2, 0, 3);
  const Lanes bYzx = __builtin_shufflevector(b, b, 1, 2, 0, 3);
  const Lanes zxy = a * bYzx - aYzx * b;
  return __builtin_shufflevector(zxy, zxy, 1, 2, 0, 3);
}

float sumOf(Lanes a) {
  return a[0] + a[1] + a[2];
}

}  // namespace

void SurfaceShapes::compute(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  places_.resize(positions.size());
  // Relative to a point of the mesh, so that cloth far from the origin is as exact.
  const Vec3 origin = positions.empty() ? Vec3(Vec3::Zero()) : positions.front();
  std::transform(positions.begin(), positions.end(), places_.begin(), [&](const Vec3& position) {
    const Eigen::Vector3f from = (position - origin).cast<float>();
    return Lanes{from.x(), from.y(), from.z(), 0.0F};
  });
  sumUp(triangles);
  shapes_.resize(positions.size());
  std::transform(sums_.begin(), sums_.end(), shapes_.begin(), shapeOf);
}

void SurfaceShapes::sumUp(std::span<const Triangle> triangles) {
  sums_.resize(places_.size());
  std::fill(sums_.begin(), sums_.end(), Sums{});
  for (const auto& [a, b, c] : triangles) {
    const Lanes ab = places_[b] - places_[a];
    const Lanes ac = places_[c] - places_[a];
    const Lanes bc = ac - ab;
    const Lanes twiceArea = cross(ab, ac);
    const auto add = [&twiceArea](Sums& sums, Lanes edges, Lanes squares) {
      sums.twiceArea += twiceArea;
      sums.toNeighbours += edges;
      sums.squares += squares;
    };
    add(sums_[a], ab + ac, ab * ab + ac * ac);
    add(sums_[b], bc - ab, ab * ab + bc * bc);
    add(sums_[c], -ac - bc, ac * ac + bc * bc);
  }
}

SurfaceShape SurfaceShapes::shapeOf(const Sums& sums) {
  const float area = std::sqrt(sumOf(sums.twiceArea * sums.twiceArea));
  const Lanes normal = area > 0.0F ? sums.twiceArea / area : Lanes{0.0F, 1.0F, 0.0F, 0.0F};
  const float squaredLengths = sumOf(sums.squares);
  // A neighbour at distance d on a surface of curvature k has distance k d^2 / 2 from the tangent plane.
  const float curvature = squaredLengths > 0.0F ? 2.0F * sumOf(normal * sums.toNeighbours) / squaredLengths : 0.0F;
  return {{normal[0], normal[1], normal[2]}, curvature};
}

}  // namespace drape::render
