#include "render/surface_shapes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace drape {

void SurfaceShapes::compute(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  const Eigen::Vector3f zero(0.0F, 0.0F, 0.0F);
  sums_.resize(positions.size());
  std::fill(sums_.begin(), sums_.end(), Sums{zero, zero, 0.0F});
  for (const auto& [a, b, c] : triangles) {
    const auto ia = static_cast<std::size_t>(a);
    const auto ib = static_cast<std::size_t>(b);
    const auto ic = static_cast<std::size_t>(c);
    const Eigen::Vector3f ab = (positions[ib] - positions[ia]).cast<float>();
    const Eigen::Vector3f ac = (positions[ic] - positions[ia]).cast<float>();
    const Eigen::Vector3f bc = ac - ab;
    const Eigen::Vector3f twiceArea = ab.cross(ac);
    const float ab2 = ab.squaredNorm();
    const float ac2 = ac.squaredNorm();
    const float bc2 = bc.squaredNorm();
    const auto add = [&twiceArea](Sums& sums, const Eigen::Vector3f& edges, float squaredLengths) {
      sums.twiceArea += twiceArea;
      sums.toNeighbours += edges;
      sums.squaredLengths += squaredLengths;
    };
    add(sums_[ia], ab + ac, ab2 + ac2);
    add(sums_[ib], bc - ab, ab2 + bc2);
    add(sums_[ic], -ac - bc, ac2 + bc2);
  }
  shapes_.resize(positions.size());
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const Sums& sums = sums_[i];
    const float area = sums.twiceArea.norm();
    SurfaceShape& shape = shapes_[i];
    shape.normal = area > 0.0F ? Eigen::Vector3f(sums.twiceArea / area) : Eigen::Vector3f(0.0F, 1.0F, 0.0F);
    // A neighbour at distance d on a surface of curvature k lies k d^2 / 2 off the tangent plane.
    shape.curvature =
        sums.squaredLengths > 0.0F ? 2.0F * shape.normal.dot(sums.toNeighbours) / sums.squaredLengths : 0.0F;
  }
}

}  // namespace drape
