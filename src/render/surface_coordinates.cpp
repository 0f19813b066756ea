#include "render/surface_coordinates.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace drape::render {
namespace {

/// Sums over triangles, weighted by their area in the rest shape.
struct Measure {
  double area = 0.0;        // [m^2]
  double alongU = 0.0;      // metres per unit of u, times area
  double alongV = 0.0;      // metres per unit of v, times area
  double mappedArea = 0.0;  // of the triangles with an area in the texture [m^2]
};

void addTriangle(const io::RenderMesh& mesh, std::span<const Vec3> rest, const Triangle& triangle, Measure& measure) {
  std::array<Vec3, 3> x;
  std::array<Vec2, 3> uv;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const int vertex = triangle[corner];
    x[corner] = rest[mesh.particle[vertex]];
    uv[corner] = mesh.uvs[vertex];
  }
  const Vec3 edge1 = x[1] - x[0];
  const Vec3 edge2 = x[2] - x[0];
  const Vec2 uv1 = uv[1] - uv[0];
  const Vec2 uv2 = uv[2] - uv[0];
  const double area = 0.5 * edge1.cross(edge2).norm();
  const double determinant = uv1.x() * uv2.y() - uv1.y() * uv2.x();
  measure.area += area;
  if (std::abs(determinant) > 1e-12) {
    measure.mappedArea += area;
    measure.alongU += area * ((edge1 * uv2.y() - edge2 * uv1.y()) / determinant).norm();
    measure.alongV += area * ((edge2 * uv1.x() - edge1 * uv2.x()) / determinant).norm();
  }
}

/// The nearest of 1, 2 and 5 times a power of ten.
double roundLength(double length) {
  const double decade = std::pow(10.0, std::floor(std::log10(length)));
  const double leading = length / decade;
  const double rounded = leading < std::sqrt(2.0)    ? 1.0
                         : leading < std::sqrt(10.0) ? 2.0
                         : leading < std::sqrt(50.0) ? 5.0
                                                     : 10.0;
  return rounded * decade;
}

/// The mesh of one cloth, whose particles keep their numbers.
io::RenderMesh meshOf(const scene::ClothPart& cloth, const io::RenderMesh& all) {
  io::RenderMesh mesh;
  const auto particles = all.particle.begin() + cloth.firstRenderVertex;
  mesh.particle.assign(particles, particles + cloth.renderVertexCount);
  const auto uvs = all.uvs.begin() + cloth.firstRenderVertex;
  mesh.uvs.assign(uvs, uvs + cloth.renderVertexCount);
  for (int t = cloth.firstTriangle; t < cloth.firstTriangle + cloth.triangleCount; ++t) {
    const auto& [a, b, c] = all.triangles[t];
    mesh.triangles.push_back({a - cloth.firstRenderVertex, b - cloth.firstRenderVertex, c - cloth.firstRenderVertex});
  }
  return mesh;
}

}  // namespace

SurfaceCoordinates surfaceCoordinates(const io::RenderMesh& mesh, std::span<const scene::ClothPart> cloths,
                                      std::span<const Vec3> restPositions) {
  if (cloths.size() == 1 || mesh.uvs.size() != mesh.particle.size()) {
    return surfaceCoordinates(mesh, restPositions);
  }
  SurfaceCoordinates all{.metres = {}, .checkSize = 0.0};
  for (const scene::ClothPart& cloth : cloths) {
    SurfaceCoordinates own = surfaceCoordinates(meshOf(cloth, mesh), restPositions);
    own.metres.resize(static_cast<std::size_t>(cloth.renderVertexCount), Vec2::Zero());
    all.metres.insert(all.metres.end(), own.metres.begin(), own.metres.end());
    all.checkSize = std::max(all.checkSize, own.checkSize);
  }
  return all;
}

SurfaceCoordinates surfaceCoordinates(const io::RenderMesh& mesh, std::span<const Vec3> restPositions) {
  SurfaceCoordinates result;
  if (mesh.uvs.size() != mesh.particle.size()) {
    return result;
  }
  Measure measure;
  for (const Triangle& triangle : mesh.triangles) {
    addTriangle(mesh, restPositions, triangle, measure);
  }
  if (measure.mappedArea <= 0.0) {
    return result;
  }
  const Vec2 metresPerUnit(measure.alongU / measure.mappedArea, measure.alongV / measure.mappedArea);
  result.metres.reserve(mesh.uvs.size());
  for (const Vec2& uv : mesh.uvs) {
    result.metres.emplace_back(uv.cwiseProduct(metresPerUnit));
  }
  Eigen::AlignedBox3d box;
  for (const Vec3& position : restPositions) {
    box.extend(position);
  }
  // A garment has several layers, so its area alone would make the checks too large.
  result.checkSize = roundLength(std::min(std::sqrt(measure.area), box.sizes().maxCoeff()) / 12.0);
  return result;
}

}  // namespace drape::render
