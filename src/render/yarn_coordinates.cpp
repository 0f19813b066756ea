#include "render/yarn_coordinates.hpp"

#include "sim/model/mesh_topology.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace drape::render {
namespace {

using Map = Eigen::Matrix2d;

/// The maps of the triangles of a piece, summed with their areas.
struct PieceSum {
  Map map = Map::Zero();       // metres along weft and warp per unit of u and v, times area
  Map mirrored = Map::Zero();  // of triangles whose texture is mirrored, with weft reversed
  double area = 0.0;           // [m^2]
  double mirroredArea = 0.0;   // [m^2]
};

/// The columns are two sides of a triangle in its texture.
Map sidesInTexture(const io::RenderMesh& mesh, const Triangle& triangle) {
  const Vec2 origin = mesh.uvs[triangle[0]];
  Map sides;
  sides << mesh.uvs[triangle[1]] - origin, mesh.uvs[triangle[2]] - origin;
  return sides;
}

void addToPiece(const io::RenderMesh& mesh, std::span<const Vec3> rest, const Triangle& triangle, const Vec3& warp,
                PieceSum& sum) {
  const Map inTexture = sidesInTexture(mesh, triangle);
  const Vec3& origin = rest[mesh.particle[triangle[0]]];
  const Vec3 side1 = rest[mesh.particle[triangle[1]]] - origin;
  const Vec3 side2 = rest[mesh.particle[triangle[2]]] - origin;
  const Vec3 areaVector = 0.5 * side1.cross(side2);
  const double area = areaVector.norm();
  if (std::abs(inTexture.determinant()) < 1e-12 || area <= 0.0) {
    return;
  }
  const Vec3 weft = warp.cross(areaVector / area);
  Map inCloth;
  inCloth << weft.dot(side1), weft.dot(side2), warp.dot(side1), warp.dot(side2);
  Map map = inCloth * inTexture.inverse();
  if (map.determinant() > 0.0) {
    sum.map += area * map;
    sum.area += area;
  } else {
    map.row(0) *= -1.0;
    sum.mirrored += area * map;
    sum.mirroredArea += area;
  }
}

/// The mean map. Where a piece is mirrored in parts, as a planar projection of a garment, the larger part decides.
Map meanOf(const PieceSum& sum) {
  const double area = sum.area + sum.mirroredArea;
  if (area <= 0.0) {
    return Map::Zero();
  }
  Map map = (sum.map + sum.mirrored) / area;
  if (sum.mirroredArea > sum.area) {
    map.row(0) *= -1.0;
  }
  return map;
}

}  // namespace

std::vector<Vec2> yarnCoordinates(const io::RenderMesh& mesh, std::span<const Vec3> restPositions,
                                  std::span<const Vec3> warp) {
  if (mesh.uvs.size() != mesh.particle.size()) {
    return {};
  }
  const sim::ConnectedComponents pieces = sim::componentsOf(mesh.triangles, mesh.uvs.size());
  std::vector<PieceSum> sums(pieces.count());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    addToPiece(mesh, restPositions, triangle, warp[t], sums[pieces.componentOf[triangle[0]]]);
  }
  std::vector<Map> maps(sums.size());
  std::transform(sums.begin(), sums.end(), maps.begin(), meanOf);
  std::vector<Vec2> result;
  result.reserve(mesh.uvs.size());
  for (std::size_t v = 0; v < mesh.uvs.size(); ++v) {
    result.emplace_back(maps[pieces.componentOf[v]] * mesh.uvs[v]);
  }
  return result;
}

}  // namespace drape::render
