#include "scene/subdivision.hpp"

#include "messages/error.hpp"
#include "scene/mesh_file.hpp"
#include "sim/model/mesh_topology.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace drape::scene {
namespace {

using Corners = std::array<int, 3>;

/// Four triangles for each: one at each corner, then that of the middles. All keep the direction of the first.
/// @param middles of the sides of each triangle, beginning with that from its first corner to its second
std::vector<Triangle> divided(std::span<const Triangle> triangles, std::span<const Corners> middles) {
  std::vector<Triangle> parts;
  parts.reserve(4 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const auto& [ab, bc, ca] = middles[t];
    parts.push_back({a, ab, ca});
    parts.push_back({ab, b, bc});
    parts.push_back({ca, bc, c});
    parts.push_back({ab, bc, ca});
  }
  return parts;
}

/// Numbers the middles of the edges of a mesh from `vertexCount` on, in the order of the edges.
/// @param visit called with each Midpoint
template <typename Visit>
std::vector<Corners> middlesOf(std::span<const Triangle> triangles, std::size_t vertexCount, const Visit& visit) {
  std::vector<Corners> middles(triangles.size());
  const sim::MeshEdges edges = sim::edgesOf(triangles, vertexCount);
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const int middle = static_cast<int>(vertexCount + e);
    for (const sim::TriangleSide& side : edges.sides[e]) {
      middles[side.triangle][side.corner] = middle;
    }
    visit(Midpoint{middle, edges.edges[e].a, edges.edges[e].b});
  }
  return middles;
}

void divideRenderMesh(const std::vector<Corners>& middlesOfCloth, io::RenderMesh& render) {
  std::vector<int> particles;  // of the middles
  const auto middles = middlesOf(render.triangles, render.particle.size(), [&](const Midpoint& midpoint) {
    particles.push_back(-1);
    const Vec2 uv = 0.5 * (render.uvs[midpoint.a] + render.uvs[midpoint.b]);
    render.uvs.push_back(uv);
  });
  for (std::size_t t = 0; t < middles.size(); ++t) {
    for (std::size_t side = 0; side < 3; ++side) {
      particles[middles[t][side] - render.particle.size()] = middlesOfCloth[t][side];
    }
  }
  render.particle.insert(render.particle.end(), particles.begin(), particles.end());
  render.triangles = divided(render.triangles, middles);
}

void divideOnce(SubdividedMesh& result) {
  sim::ClothMesh& cloth = result.mesh.cloth;
  const auto middles = middlesOf(cloth.triangles, cloth.positions.size(), [&](const Midpoint& midpoint) {
    result.midpoints.push_back(midpoint);
    const Vec3 position = 0.5 * (cloth.positions[midpoint.a] + cloth.positions[midpoint.b]);
    cloth.positions.push_back(position);
  });
  cloth.triangles = divided(cloth.triangles, middles);
  divideRenderMesh(middles, result.mesh.render);
}

}  // namespace

SubdividedMesh subdivided(io::ImportedMesh mesh, int times) {
  SubdividedMesh result{std::move(mesh), {}};
  if (times == 0) {
    return result;
  }
  io::MeshSummary& summary = result.mesh.summary;
  const double triangles = static_cast<double>(result.mesh.cloth.triangles.size()) * std::pow(4.0, times);
  if (triangles > maxSubdividedTriangles) {
    throw messages::InputError(fmt::format(
        "{}: subdivide = {} would divide its {} triangles into {:.0f} ({} at most); choose a smaller number",
        summary.source, times, result.mesh.cloth.triangles.size(), triangles, maxSubdividedTriangles));
  }
  for (int i = 0; i < times; ++i) {
    divideOnce(result);
  }
  result.mesh.file = fileMeshOf(result.mesh);
  summary.vertices = static_cast<int>(result.mesh.cloth.positions.size());
  summary.triangles = static_cast<int>(result.mesh.cloth.triangles.size());
  summary.springs = static_cast<int>(sim::edgesOf(result.mesh.cloth.triangles, summary.vertices).edges.size());
  return result;
}

void addMidpoints(std::span<const Midpoint> midpoints, std::vector<int>& vertices) {
  std::set<int> all(vertices.begin(), vertices.end());
  for (const Midpoint& midpoint : midpoints) {
    if (all.contains(midpoint.a) && all.contains(midpoint.b)) {
      all.insert(midpoint.vertex);
      vertices.push_back(midpoint.vertex);
    }
  }
}

}  // namespace drape::scene
