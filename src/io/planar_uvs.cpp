#include "io/planar_uvs.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>

namespace drape::io {
namespace {

/// The axis (0, 1, 2 for x, y, z) closest to a face's normal.
std::size_t mainAxis(const sim::ClothMesh& cloth, const Triangle& face) {
  const Vec3& a = cloth.positions[face[0]];
  const Vec3& b = cloth.positions[face[1]];
  const Vec3& c = cloth.positions[face[2]];
  Eigen::Index axis = 0;
  (b - a).cross(c - a).cwiseAbs().maxCoeff(&axis);
  return static_cast<std::size_t>(axis);
}

/// The projection of a position along an axis, with y upwards if possible.
Vec2 seenAlong(std::size_t axis, const Vec3& position) {
  switch (axis) {
    case 0:
      return {position.z(), position.y()};
    case 1:
      return {position.x(), position.z()};
    default:
      return {position.x(), position.y()};
  }
}

}  // namespace

RenderMesh renderMeshFromPlanes(const sim::ClothMesh& cloth) {
  RenderMesh render;
  render.uvsInMetres = true;
  std::vector<std::array<int, 3>> byAxis(cloth.positions.size(), {-1, -1, -1});
  for (const Triangle& face : cloth.triangles) {
    const std::size_t axis = mainAxis(cloth, face);
    Triangle drawn{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const int particle = face[corner];
      int& vertex = byAxis[particle][axis];
      if (vertex < 0) {
        vertex = static_cast<int>(render.particle.size());
        render.particle.push_back(face[corner]);
        render.uvs.push_back(seenAlong(axis, cloth.positions[particle]));
      }
      drawn[corner] = vertex;
    }
    render.triangles.push_back(drawn);
  }
  return render;
}

}  // namespace drape::io
