#include "sim/model/normals.hpp"

namespace drape::sim {

Vec3 vertexNormal(const ClothModel& model, std::span<const Vec3> positions, int vertex) {
  Vec3 sum = Vec3::Zero();
  for (const int triangle : model.vertexTriangles[vertex]) {
    const Triangle& t = model.triangles[triangle];
    const Vec3& a = positions[t[0]];
    sum += (positions[t[1]] - a).cross(positions[t[2]] - a);
  }
  const double size = sum.norm();
  return size > 0.0 ? Vec3(sum / size) : Vec3(Vec3::Zero());
}

}  // namespace drape::sim
