#include "sim/normals.hpp"

namespace drape {

Vec3 vertexNormal(const ClothModel& model, std::span<const Vec3> positions, int vertex) {
  Vec3 sum = Vec3::Zero();
  const auto row = static_cast<std::size_t>(vertex);
  for (int i = model.vertexTriangles.begin[row]; i < model.vertexTriangles.begin[row + 1]; ++i) {
    const int triangle = model.vertexTriangles.values[static_cast<std::size_t>(i)];
    const Triangle& t = model.triangles[static_cast<std::size_t>(triangle)];
    const Vec3& a = positions[static_cast<std::size_t>(t[0])];
    sum += (positions[static_cast<std::size_t>(t[1])] - a).cross(positions[static_cast<std::size_t>(t[2])] - a);
  }
  const double size = sum.norm();
  return size > 0.0 ? Vec3(sum / size) : Vec3(Vec3::Zero());
}

}  // namespace drape
