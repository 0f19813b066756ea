#include "io/garments/delaunay.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace drape::io {
namespace {

/// A triangle and its circumscribed circle.
struct Cell {
  Triangle corners{};
  Vec2 centre;
  double squaredRadius = 0.0;
};

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

Cell makeCell(const std::vector<Vec2>& points, int a, int b, int c) {
  const Vec2& origin = points[a];
  const Vec2 ab = points[b] - origin;
  const Vec2 ac = points[c] - origin;
  const double twice = 2.0 * cross(ab, ac);
  const Vec2 toCentre((ac.y() * ab.squaredNorm() - ab.y() * ac.squaredNorm()) / twice,
                      (ab.x() * ac.squaredNorm() - ac.x() * ab.squaredNorm()) / twice);
  return {{a, b, c}, origin + toCentre, toCentre.squaredNorm()};
}

/// Adds a point: removes the triangles whose circle contains it, and fills the hole with a fan around the point.
void insertPoint(const std::vector<Vec2>& points, int point, std::vector<Cell>& cells) {
  // The border of the hole: sides of exactly one of its triangles.
  std::map<std::pair<int, int>, int> sides;
  const auto makesWay = [&](const Cell& cell) {
    const double distance = (points[point] - cell.centre).squaredNorm();
    // A point on the circle counts as outside, so that ties are resolved consistently.
    if (distance >= cell.squaredRadius * (1.0 - 1e-10)) {
      return false;
    }
    for (std::size_t corner = 0; corner < 3; ++corner) {
      ++sides[{cell.corners[corner], cell.corners[(corner + 1) % 3]}];
    }
    return true;
  };
  std::erase_if(cells, makesWay);
  for (const auto& [side, count] : sides) {
    if (!sides.contains({side.second, side.first})) {
      cells.push_back(makeCell(points, side.first, side.second, point));
    }
  }
}

}  // namespace

std::vector<Triangle> delaunay(const std::vector<Vec2>& points) {
  Vec2 low = points.front();
  Vec2 high = points.front();
  for (const Vec2& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  // Start with a triangle of three distant points around everything.
  const int count = static_cast<int>(points.size());
  const Vec2 middle = (low + high) / 2.0;
  const double reach = 1000.0 * (high - low).norm();
  std::vector<Vec2> all = points;
  all.emplace_back(middle + Vec2(-reach, -reach));
  all.emplace_back(middle + Vec2(reach, -reach));
  all.emplace_back(middle + Vec2(0.0, reach));
  std::vector<Cell> cells{makeCell(all, count, count + 1, count + 2)};
  for (int point = 0; point < count; ++point) {
    insertPoint(all, point, cells);
  }
  std::vector<Triangle> triangles;
  for (const Cell& cell : cells) {
    if (*std::max_element(cell.corners.begin(), cell.corners.end()) < count) {
      triangles.push_back(cell.corners);
    }
  }
  return triangles;
}

}  // namespace drape::io
