#include "render/creases.hpp"

#include "sim/model/ragged_rows.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

namespace drape::render {
namespace {

/// A triangle and the index of its corner at the vertex in question.
struct Corner {
  std::size_t triangle = 0;
  std::size_t corner = 0;
};

std::vector<Vec3> unitNormals(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  std::vector<Vec3> normals;
  normals.reserve(triangles.size());
  for (const Triangle& triangle : triangles) {
    const Vec3& a = positions[triangle[0]];
    const Vec3& b = positions[triangle[1]];
    const Vec3& c = positions[triangle[2]];
    normals.emplace_back((b - a).cross(c - a).normalized());
  }
  return normals;
}

sim::RaggedRows<Corner> cornersOfVertices(std::size_t vertices, std::span<const Triangle> triangles) {
  return sim::RaggedRows<Corner>::collect(vertices, [&](const auto& add) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t c = 0; c < 3; ++c) {
        add(triangles[t][c], {t, c});
      }
    }
  });
}

/// Whether two triangles at a vertex share an edge.
bool shareAnEdge(const Triangle& a, const Triangle& b) {
  const auto shared =
      std::count_if(a.begin(), a.end(), [&b](int vertex) { return std::find(b.begin(), b.end(), vertex) != b.end(); });
  return shared >= 2;
}

}  // namespace

CreasedMesh splitAtCreases(std::span<const Vec3> positions, std::span<const Triangle> triangles, double angle) {
  const double smallestCosine = std::cos(angle);
  const std::vector<Vec3> normals = unitNormals(positions, triangles);
  CreasedMesh mesh;
  mesh.triangles.assign(triangles.begin(), triangles.end());
  std::vector<Corner> group;
  std::vector<Corner> rest;
  const sim::RaggedRows<Corner> corners = cornersOfVertices(positions.size(), triangles);
  for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
    rest.assign(corners[vertex].begin(), corners[vertex].end());
    while (!rest.empty()) {
      // A group grows from one corner over all edges that are not sharp. It gets its own vertex.
      group.assign(1, rest.back());
      rest.pop_back();
      for (std::size_t i = 0; i < group.size(); ++i) {
        const std::size_t from = group[i].triangle;
        const auto isSmooth = [&](const Corner& other) {
          return shareAnEdge(triangles[from], triangles[other.triangle]) &&
                 normals[from].dot(normals[other.triangle]) >= smallestCosine;
        };
        const auto moved = std::partition(rest.begin(), rest.end(), std::not_fn(isSmooth));
        group.insert(group.end(), moved, rest.end());
        rest.erase(moved, rest.end());
      }
      for (const Corner& corner : group) {
        mesh.triangles[corner.triangle][corner.corner] = static_cast<int>(mesh.positions.size());
      }
      mesh.positions.push_back(positions[vertex]);
    }
  }
  return mesh;
}

}  // namespace drape::render
