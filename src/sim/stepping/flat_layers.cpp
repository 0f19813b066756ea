#include "sim/stepping/flat_layers.hpp"

#include "sim/contact/closest_features/triangle_geometry.hpp"
#include "sim/model/mesh_topology.hpp"
#include "sim/model/normals.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim {
namespace {

constexpr double flatness = 1e-3;    // distance from the plane of the other triangle, in thicknesses
constexpr double gapRatio = 0.1;     // smallest distance between layers of different parts, in thicknesses
constexpr double largestGap = 0.25;  // of all parts together, in thicknesses

/// Whether all corners of the second triangle are in the plane of the first.
bool isInPlaneOf(const Triangle& first, const Triangle& second, std::span<const Vec3> positions, double tolerance) {
  const Vec3 normal = contact::faceNormal(contact::cornersOf(positions, first));
  return std::ranges::all_of(
      second, [&](int v) { return std::abs(normal.dot(positions[v] - positions[first[0]])) <= tolerance; });
}

/// The vertices of triangles that intersect in one plane.
std::vector<char> flatVertices(const ClothModel& model, std::span<const intersection::TrianglePair> pairs,
                               double tolerance, std::span<const Vec3> positions) {
  std::vector<char> flat(positions.size(), 0);
  for (const auto& [a, b] : pairs) {
    const Triangle& first = model.triangles[a];
    const Triangle& second = model.triangles[b];
    if (isInPlaneOf(first, second, positions, tolerance) && isInPlaneOf(second, first, positions, tolerance)) {
      for (const Triangle& triangle : {first, second}) {
        for (const int v : triangle) {
          flat[v] = 1;
        }
      }
    }
  }
  return flat;
}

/// The number of edges from the first vertex of its part, relative to the largest number: 0 to 1. It differs between
/// most layers of a part that is folded several times.
std::vector<double> depthsOf(const ClothModel& model, const ConnectedComponents& parts) {
  std::vector<int> depths(parts.componentOf.size(), -1);
  std::vector<int> queue = parts.lowestVertex;
  for (const int v : queue) {
    depths[v] = 0;
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const int triangle : model.vertexTriangles[queue[i]]) {
      for (const int v : model.triangles[triangle]) {
        if (depths[v] < 0) {
          depths[v] = depths[queue[i]] + 1;
          queue.push_back(v);
        }
      }
    }
  }
  const double deepest = std::max(1, *std::ranges::max_element(depths));
  std::vector<double> relative;
  relative.reserve(depths.size());
  for (const int depth : depths) {
    relative.push_back(depth / deepest);
  }
  return relative;
}

}  // namespace

void openFlatLayers(const ClothModel& model, std::span<const intersection::TrianglePair> pairs, double thickness,
                    std::vector<Vec3>& positions) {
  const std::vector<char> flat = flatVertices(model, pairs, flatness * thickness, positions);
  if (std::ranges::find(flat, 1) == flat.end()) {
    return;
  }
  const ConnectedComponents parts = componentsOf(model.triangles, positions.size());
  const std::vector<double> depths = depthsOf(model, parts);
  const double gap = thickness * std::min(gapRatio, largestGap / (2.0 * parts.count()));
  const std::vector<Vec3> before = positions;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (flat[v] == 0) {
      continue;
    }
    const Vec3 normal = vertexNormal(model, before, static_cast<int>(v));
    positions[v] += gap * (1.0 + 2.0 * parts.componentOf[v] + depths[v]) * normal;
  }
}

}  // namespace drape::sim
