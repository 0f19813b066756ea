#include "io/garments/implicit_solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace drape::io {
namespace {

/// The nodes and cells of a grid; a cell has the index of its lowest node.
class NodeGrid {
 public:
  NodeGrid(const Vec3& min, const Vec3& max, double cell) : min_(min), cell_(cell) {
    for (int axis = 0; axis < 3; ++axis) {
      count_[axis] = static_cast<int>(std::ceil((max[axis] - min[axis]) / cell)) + 1;
    }
  }
  [[nodiscard]] std::size_t nodes() const {
    return static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) *
           static_cast<std::size_t>(count_[2]);
  }
  [[nodiscard]] int count(int axis) const { return count_[axis]; }
  [[nodiscard]] std::size_t index(const std::array<int, 3>& node) const {
    return static_cast<std::size_t>(node[0]) +
           static_cast<std::size_t>(count_[0]) *
               (static_cast<std::size_t>(node[1]) +
                static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(node[2]));
  }
  [[nodiscard]] Vec3 at(const std::array<int, 3>& node) const { return min_ + cell_ * Vec3(node[0], node[1], node[2]); }
  template <typename Visit>
  void forEachNode(Visit&& visit) const {
    for (int z = 0; z < count_[2]; ++z) {
      for (int y = 0; y < count_[1]; ++y) {
        for (int x = 0; x < count_[0]; ++x) {
          visit(std::array<int, 3>{x, y, z});
        }
      }
    }
  }

 private:
  Vec3 min_;
  double cell_;
  std::array<int, 3> count_{};
};

std::array<int, 3> moved(std::array<int, 3> node, int axis, int by) {
  node[axis] += by;
  return node;
}

/// Builds the mesh: first the vertices of the cells, then the faces of the edges.
class SurfaceNet {
 public:
  SurfaceNet(const SolidDistance& distance, const NodeGrid& grid)
      : grid_(grid), values_(grid.nodes()), vertexOf_(grid.nodes(), -1) {
    grid.forEachNode([&](const auto& node) { values_[grid.index(node)] = distance(grid.at(node)); });
    grid.forEachNode([&](const auto& node) { addVertex(node); });
    grid.forEachNode([&](const auto& node) {
      for (int axis = 0; axis < 3; ++axis) {
        addFace(node, axis);
      }
    });
  }
  [[nodiscard]] RawMesh take() { return std::move(mesh_); }

 private:
  [[nodiscard]] double value(const std::array<int, 3>& node) const { return values_[grid_.index(node)]; }

  [[nodiscard]] bool hasCell(const std::array<int, 3>& node) const {
    return node[0] + 1 < grid_.count(0) && node[1] + 1 < grid_.count(1) && node[2] + 1 < grid_.count(2);
  }

  /// Adds a vertex at the mean of the points where the surface crosses the cell's edges.
  void addVertex(const std::array<int, 3>& cell) {
    if (!hasCell(cell)) {
      return;
    }
    Vec3 sum = Vec3::Zero();
    int crossings = 0;
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 4; ++side) {
        const auto from = moved(moved(cell, (axis + 1) % 3, side & 1), (axis + 2) % 3, side >> 1);
        const auto to = moved(from, axis, 1);
        const double a = value(from);
        const double b = value(to);
        if ((a < 0.0) != (b < 0.0)) {
          sum += grid_.at(from) + a / (a - b) * (grid_.at(to) - grid_.at(from));
          ++crossings;
        }
      }
    }
    if (crossings > 0) {
      vertexOf_[grid_.index(cell)] = static_cast<int>(mesh_.positions.size());
      mesh_.positions.emplace_back(sum / crossings);
    }
  }

  /// Adds the quad of the four cells around an edge that crosses the surface, cut along its shorter diagonal.
  void addFace(const std::array<int, 3>& node, int axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const auto end = moved(node, axis, 1);
    if (end[axis] >= grid_.count(axis) || node[u] == 0 || node[v] == 0 || (value(node) < 0.0) == (value(end) < 0.0)) {
      return;
    }
    std::array<int, 4> quad = {vertexOf_[grid_.index(moved(moved(node, u, -1), v, -1))],
                               vertexOf_[grid_.index(moved(node, v, -1))], vertexOf_[grid_.index(node)],
                               vertexOf_[grid_.index(moved(node, u, -1))]};
    if (value(node) >= 0.0) {
      std::swap(quad[1], quad[3]);
    }
    const auto length = [&](int a, int b) { return (mesh_.positions[a] - mesh_.positions[b]).norm(); };
    const bool first = length(quad[0], quad[2]) <= length(quad[1], quad[3]);
    mesh_.triangles.push_back(first ? Triangle{quad[0], quad[1], quad[2]} : Triangle{quad[0], quad[1], quad[3]});
    mesh_.triangles.push_back(first ? Triangle{quad[0], quad[2], quad[3]} : Triangle{quad[1], quad[2], quad[3]});
  }

  const NodeGrid& grid_;
  std::vector<double> values_;
  std::vector<int> vertexOf_;
  RawMesh mesh_;
};

Vec3 gradientOf(const SolidDistance& distance, const Vec3& point) {
  constexpr double reach = 1e-5;  // [m]
  Vec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 offset = reach * Vec3::Unit(axis);
    gradient[axis] = (distance(point + offset) - distance(point - offset)) / (2.0 * reach);
  }
  return gradient;
}

void putOnSurface(const SolidDistance& distance, std::vector<Vec3>& positions) {
  constexpr int passes = 3;
  for (Vec3& position : positions) {
    for (int pass = 0; pass < passes; ++pass) {
      const Vec3 gradient = gradientOf(distance, position);
      position -= distance(position) * gradient / std::max(gradient.squaredNorm(), 0.01);
    }
  }
}

/// Moves each vertex halfway to the mean of its neighbours.
void evenOut(RawMesh& mesh) {
  std::vector<Vec3> sum(mesh.positions.size(), Vec3::Zero());
  std::vector<int> count(mesh.positions.size(), 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const int self = triangle[corner];
      sum[self] += mesh.positions[triangle[(corner + 1) % 3]];
      sum[self] += mesh.positions[triangle[(corner + 2) % 3]];
      count[self] += 2;
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    mesh.positions[i] = 0.5 * mesh.positions[i] + 0.5 * sum[i] / std::max(1, count[i]);
  }
}

}  // namespace

double distanceTo(const TaperedBar& bar, const Vec3& point) {
  const auto flattened = [&](const Vec3& v) { return Vec3(v.x(), v.y(), v.z() / bar.flatness); };
  const Vec3 along = flattened(bar.to - bar.from);
  const Vec3 offset = flattened(point - bar.from);
  const double t = std::clamp(offset.dot(along) / along.squaredNorm(), 0.0, 1.0);
  return bar.flatness * ((offset - t * along).norm() - (bar.fromRadius + t * (bar.toRadius - bar.fromRadius)));
}

double distanceTo(const Ellipsoid& ellipsoid, const Vec3& point) {
  const Vec3 offset = point - ellipsoid.centre;
  const double radius = offset.cwiseQuotient(ellipsoid.half).norm();
  const double steepness = offset.cwiseQuotient(ellipsoid.half.cwiseAbs2()).norm();
  return steepness > 0.0 ? radius * (radius - 1.0) / steepness : -ellipsoid.half.minCoeff();
}

double joined(double a, double b, double fillet) {
  const double overlap = std::max(0.0, 1.0 - std::abs(a - b) / fillet);
  return std::min(a, b) - overlap * overlap * fillet / 4.0;
}

RawMesh surfaceOf(const SolidDistance& distance, const Vec3& min, const Vec3& max, double cell) {
  RawMesh mesh = SurfaceNet(distance, NodeGrid(min, max, cell)).take();
  constexpr int passes = 5;
  for (int pass = 0; pass < passes; ++pass) {
    evenOut(mesh);
    putOnSurface(distance, mesh.positions);
  }
  return mesh;
}

}  // namespace drape::io
