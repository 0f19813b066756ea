#include "sim/simd/sliced_fans.hpp"

#include "sim/fabric/fabric.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace drape::sim::simd {
namespace {

/// A triangle at a vertex, between two of its neighbours.
struct FanTriangle {
  int first = 0;          // the neighbour after the vertex in the triangle's order
  int second = 0;         // the one before it
  std::size_t index = 0;  // of the triangle
  std::size_t corner = 0;
  bool used = false;
};

/// The triangle between a spoke and the spoke before it.
struct FanSector {
  std::size_t triangle = 0;
  std::size_t corner = 0;  // of the triangle, at the vertex
  bool turned = false;     // the spokes are in the reverse order of the triangle's
};

/// A spoke of a vertex. The first spoke of each part of a fan has no sector.
struct Spoke {
  int neighbour = 0;  // vertex of the model
  std::optional<FanSector> sector;
};

std::vector<FanTriangle> trianglesAt(const ClothModel& model, int vertex) {
  std::vector<FanTriangle> triangles;
  for (const int t : model.vertexTriangles[static_cast<std::size_t>(vertex)]) {
    const Triangle& triangle = model.triangles[static_cast<std::size_t>(t)];
    const auto corner = static_cast<std::size_t>(std::ranges::find(triangle, vertex) - triangle.begin());
    triangles.push_back({triangle[(corner + 1) % 3], triangle[(corner + 2) % 3], static_cast<std::size_t>(t), corner});
  }
  return triangles;
}

/// Walks around the vertex from triangle to triangle. A part begins at the boundary if it has one.
std::vector<Spoke> fanOf(const ClothModel& model, int vertex) {
  std::vector<FanTriangle> triangles = trianglesAt(model, vertex);
  std::map<int, int> triangleCount;  // of each neighbour, not used yet
  for (const FanTriangle& triangle : triangles) {
    ++triangleCount[triangle.first];
    ++triangleCount[triangle.second];
  }
  std::vector<Spoke> spokes;
  const auto unused = [](const FanTriangle& triangle) { return !triangle.used; };
  while (std::ranges::any_of(triangles, unused)) {
    const auto atBoundary = std::ranges::find_if(
        triangles, [&](const FanTriangle& triangle) { return !triangle.used && triangleCount[triangle.first] == 1; });
    const auto start = atBoundary != triangles.end() ? atBoundary : std::ranges::find_if(triangles, unused);
    int at = start->first;
    spokes.push_back({at, std::nullopt});
    for (auto next = start; next != triangles.end();) {
      next->used = true;
      --triangleCount[next->first];
      --triangleCount[next->second];
      const bool turned = next->first != at;
      at = turned ? next->first : next->second;
      spokes.push_back({at, FanSector{next->index, next->corner, turned}});
      next = std::ranges::find_if(triangles, [&](const FanTriangle& triangle) {
        return !triangle.used && (triangle.first == at || triangle.second == at);
      });
    }
  }
  return spokes;
}

template <typename T>
void setSector(const fabric::Fabric& fabric, const FanSector& sector, std::size_t lane,
               typename SlicedFabric<T>::Sector& numbers) {
  const fabric::RestTriangle& rest = fabric.shape.triangles[sector.triangle];
  Eigen::Matrix2d sides;
  sides << rest.sides[sector.corner], -rest.sides[(sector.corner + 2) % 3];
  Eigen::Matrix2d inverse = Eigen::Matrix2d::Zero();
  // A degenerate triangle has no stiffness, but the air acts on it.
  double area = std::sqrt(std::numeric_limits<float>::min());
  if (rest.area > 0.0) {
    inverse = sides.inverse();
    area = rest.area * fabric.membraneScales[sector.triangle];
  }
  const Eigen::Index a = sector.turned ? 1 : 0;
  numbers.a1[lane] = static_cast<T>(inverse(a, 0));
  numbers.a2[lane] = static_cast<T>(inverse(a, 1));
  numbers.b1[lane] = static_cast<T>(inverse(1 - a, 0));
  numbers.b2[lane] = static_cast<T>(inverse(1 - a, 1));
  numbers.area[lane] = static_cast<T>(sector.turned ? -area : area);
}

/// The slot of one spoke of all lanes: consecutive neighbours, or a table.
template <typename T>
SliceLayout::Slot slotOf(const SliceLayout::NeighbourTable& table, SlicedFabric<T>& fabric) {
  for (int lane = 1; lane < sliceLanes; ++lane) {
    if (table[lane] != table[0] + lane) {
      fabric.spokeTables.push_back(table);
      return {.table = static_cast<int>(fabric.spokeTables.size()) - 1};
    }
  }
  return {.first = table[0]};
}

}  // namespace

template <typename T>
void addFansOfSlice(const ClothModel& model, const SliceLayout& layout, int slice, SlicedFabric<T>& fabric) {
  const int first = slice * sliceLanes;
  std::array<std::vector<Spoke>, sliceLanes> fans;
  std::size_t spokes = 0;
  for (int lane = 0; lane < sliceLanes && first + lane < layout.vertices; ++lane) {
    fans[lane] = fanOf(model, layout.order[first + lane]);
    spokes = std::max(spokes, fans[lane].size());
  }
  for (std::size_t s = 0; s < spokes; ++s) {
    SliceLayout::NeighbourTable table{};
    auto& sector = fabric.sectors.emplace_back();
    for (std::size_t lane = 0; lane < sliceLanes; ++lane) {
      const int own = std::min(first + static_cast<int>(lane), layout.vertices - 1);
      table[lane] = s < fans[lane].size() ? layout.indexOf[fans[lane][s].neighbour] : own;
      if (s < fans[lane].size() && fans[lane][s].sector) {
        setSector<T>(*model.fabric, *fans[lane][s].sector, lane, sector);
      }
    }
    fabric.spokes.push_back(slotOf(table, fabric));
  }
}

template void addFansOfSlice(const ClothModel& model, const SliceLayout& layout, int slice,
                             SlicedFabric<float>& fabric);
template void addFansOfSlice(const ClothModel& model, const SliceLayout& layout, int slice,
                             SlicedFabric<double>& fabric);

}  // namespace drape::sim::simd
