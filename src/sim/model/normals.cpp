#include "sim/model/normals.hpp"

namespace drape::sim {

Vec3 doubleAreaNormal(const Triangle& triangle, std::span<const Vec3> positions) {
  const Vec3& a = positions[triangle[0]];
  return (positions[triangle[1]] - a).cross(positions[triangle[2]] - a);
}

Vec3 vertexNormal(const ClothModel& model, std::span<const Vec3> positions, int vertex) {
  Vec3 sum = Vec3::Zero();
  for (const int triangle : model.vertexTriangles[vertex]) {
    sum += doubleAreaNormal(model.triangles[triangle], positions);
  }
  const double size = sum.norm();
  return size > 0.0 ? Vec3(sum / size) : Vec3(Vec3::Zero());
}

}  // namespace drape::sim
