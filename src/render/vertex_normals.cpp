#include "render/vertex_normals.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace drape {

void areaWeightedNormals(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                         std::vector<Eigen::Vector3f>& normals) {
  normals.resize(positions.size());
  std::fill(normals.begin(), normals.end(), Eigen::Vector3f(0.0F, 0.0F, 0.0F));
  for (const auto& [a, b, c] : triangles) {
    const auto ia = static_cast<std::size_t>(a);
    const auto ib = static_cast<std::size_t>(b);
    const auto ic = static_cast<std::size_t>(c);
    const Eigen::Vector3f ab = (positions[ib] - positions[ia]).cast<float>();
    const Eigen::Vector3f ac = (positions[ic] - positions[ia]).cast<float>();
    const Eigen::Vector3f twiceArea = ab.cross(ac);
    normals[ia] += twiceArea;
    normals[ib] += twiceArea;
    normals[ic] += twiceArea;
  }
  for (Eigen::Vector3f& normal : normals) {
    const float squared = normal.squaredNorm();
    normal = squared > 0.0F ? Eigen::Vector3f(normal / std::sqrt(squared)) : Eigen::Vector3f(0.0F, 1.0F, 0.0F);
  }
}

}  // namespace drape
