#include "io/short_edges.hpp"

#include "sim/model/mesh_topology.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>

namespace drape::io {
namespace {

struct Edge {
  double length = 0.0;
  int low = 0;
  int high = 0;

  bool operator<(const Edge& other) const {
    return std::tie(length, low, high) < std::tie(other.length, other.low, other.high);
  }
  bool operator==(const Edge& other) const { return low == other.low && high == other.high; }
};

/// The edges below the limit, shortest first, without duplicates.
std::vector<Edge> shortEdges(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles, double limit) {
  std::vector<Edge> edges;
  sim::forEachSide(triangles, [&](int from, int to) {
    const auto [low, high] = std::minmax({from, to});
    const double length = (positions[high] - positions[low]).norm();
    if (length < limit) {
      edges.push_back({length, low, high});
    }
  });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

bool hasCorner(const Triangle& face, int vertex) {
  return std::find(face.begin(), face.end(), vertex) != face.end();
}

/// A mesh during edge collapses.
class Collapser {
 public:
  Collapser(const std::vector<Vec3>& positions, std::vector<Triangle> triangles)
      : positions_(positions),
        faces_(std::move(triangles)),
        facesOf_(positions.size()),
        replacement_(positions.size()) {
    for (std::size_t i = 0; i < replacement_.size(); ++i) {
      replacement_[i] = static_cast<int>(i);
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (const int vertex : faces_[f]) {
        facesOf_[vertex].push_back(f);
      }
    }
  }

  /// The vertex that replaces this one now.
  [[nodiscard]] int standIn(int vertex) const {
    while (replacement_[vertex] != vertex) {
      vertex = replacement_[vertex];
    }
    return vertex;
  }

  [[nodiscard]] double distance(int a, int b) const { return (positions_[a] - positions_[b]).norm(); }

  /// Whether the two vertices are still joined by an edge.
  [[nodiscard]] bool joined(int a, int b) const { return !facesAt(a, b).empty(); }

  [[nodiscard]] bool canCollapse(int low, int high) const { return keepsTopology(low, high) && turnsNoFace(low, high); }

  void collapse(int low, int high) {
    for (const std::size_t face : facesOf_[high]) {
      if (hasCorner(faces_[face], low)) {
        removeFace(face, high);
      } else {
        std::replace(faces_[face].begin(), faces_[face].end(), high, low);
        facesOf_[low].push_back(face);
      }
    }
    facesOf_[high].clear();
    replacement_[high] = low;
  }

  std::vector<int> takeReplacements() {
    for (std::size_t i = 0; i < replacement_.size(); ++i) {
      replacement_[i] = standIn(static_cast<int>(i));
    }
    return std::move(replacement_);
  }

 private:
  [[nodiscard]] std::vector<std::size_t> facesAt(int a, int b) const {
    std::vector<std::size_t> faces;
    for (const std::size_t face : facesOf_[a]) {
      if (hasCorner(faces_[face], b)) {
        faces.push_back(face);
      }
    }
    return faces;
  }

  [[nodiscard]] std::set<int> neighbours(int vertex) const {
    std::set<int> all;
    for (const std::size_t face : facesOf_[vertex]) {
      all.insert(faces_[face].begin(), faces_[face].end());
    }
    all.erase(vertex);
    return all;
  }

  [[nodiscard]] bool onBoundary(int vertex) const {
    const std::set<int> around = neighbours(vertex);
    return std::any_of(around.begin(), around.end(), [&](int other) { return facesAt(vertex, other).size() == 1; });
  }

  /// The link condition: the ends have no common neighbours except the third corners of the edge's faces, an inner edge
  /// does not join two boundary vertices, and some face remains.
  [[nodiscard]] bool keepsTopology(int low, int high) const {
    const std::size_t own = facesAt(low, high).size();
    const std::set<int> around = neighbours(low);
    std::size_t common = 0;
    for (const int other : neighbours(high)) {
      common += around.count(other);
    }
    if (own > 2 || common != own) {
      return false;
    }
    if (own == 2 && onBoundary(low) && onBoundary(high)) {
      return false;
    }
    return facesOf_[low].size() + facesOf_[high].size() > 2 * own;
  }

  [[nodiscard]] Vec3 normalOf(const Triangle& face) const {
    const Vec3& a = positions_[face[0]];
    return (positions_[face[1]] - a).cross(positions_[face[2]] - a);
  }

  [[nodiscard]] bool turnsNoFace(int low, int high) const {
    return std::all_of(facesOf_[high].begin(), facesOf_[high].end(), [&](std::size_t face) {
      if (hasCorner(faces_[face], low)) {
        return true;  // the face vanishes
      }
      Triangle moved = faces_[face];
      std::replace(moved.begin(), moved.end(), high, low);
      return normalOf(faces_[face]).dot(normalOf(moved)) > 0.0;
    });
  }

  void removeFace(std::size_t face, int exceptFrom) {
    for (const int vertex : faces_[face]) {
      if (vertex != exceptFrom) {
        std::vector<std::size_t>& list = facesOf_[vertex];
        list.erase(std::find(list.begin(), list.end(), face));
      }
    }
  }

  const std::vector<Vec3>& positions_;
  std::vector<Triangle> faces_;
  std::vector<std::vector<std::size_t>> facesOf_;
  std::vector<int> replacement_;
};

}  // namespace

ShortEdges collapseShortEdges(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
                              double limit) {
  ShortEdges result;
  const std::vector<Edge> edges = shortEdges(positions, triangles, limit);
  if (edges.empty()) {
    return result;
  }
  result.where = positions[edges.front().low];
  Collapser collapser(positions, triangles);
  for (const Edge& edge : edges) {
    const auto [low, high] = std::minmax({collapser.standIn(edge.low), collapser.standIn(edge.high)});
    if (low == high || !collapser.joined(low, high) || collapser.distance(low, high) >= limit) {
      continue;
    }
    const bool possible = collapser.canCollapse(low, high);
    ++(possible ? result.collapsed : result.kept);
    if (possible) {
      collapser.collapse(low, high);
    }
  }
  result.replacement = collapser.takeReplacements();
  return result;
}

}  // namespace drape::io
