#include "scene/boundary_loops.hpp"

#include "sim/disjoint_sets.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

namespace drape {
namespace {

using Edge = std::pair<int, int>;  // lower vertex first

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

/// The sides of all triangles, sorted, so that the sides of one edge are neighbours.
std::vector<Edge> sortedSides(const std::vector<Triangle>& triangles) {
  std::vector<Edge> sides;
  sides.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const int a = triangle[corner];
      const int b = triangle[(corner + 1) % 3];
      sides.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// The boundary edges at each boundary vertex, with a flag for visited edges.
class BoundaryWalk {
 public:
  explicit BoundaryWalk(const std::vector<Edge>& edges) : edges_(edges), walked_(edges.size(), false) {
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
      edgesAt_[edges[edge].first].push_back(edge);
      edgesAt_[edges[edge].second].push_back(edge);
    }
  }

  /// Follows unused edges from `start` until it returns or there are none; empty when there are none at all.
  std::vector<int> walkFrom(int start) {
    std::vector<int> vertices;
    int here = start;
    do {
      const int next = step(here);
      if (next < 0) {
        break;
      }
      vertices.push_back(here);
      here = next;
    } while (here != start);
    return vertices;
  }

  /// The boundary vertices, ascending.
  [[nodiscard]] std::vector<int> vertices() const {
    std::vector<int> list;
    for (const auto& [vertex, edges] : edgesAt_) {
      list.push_back(vertex);
    }
    return list;
  }

 private:
  int step(int here) {
    for (const std::size_t edge : edgesAt_.at(here)) {
      if (!walked_[edge]) {
        walked_[edge] = true;
        return edges_[edge].first == here ? edges_[edge].second : edges_[edge].first;
      }
    }
    return -1;
  }

  const std::vector<Edge>& edges_;
  std::vector<bool> walked_;
  std::map<int, std::vector<std::size_t>> edgesAt_;
};

BoundaryLoop measured(std::vector<int> vertices, const std::vector<Vec3>& positions) {
  BoundaryLoop loop;
  const Vec3 origin = positions[at(vertices.front())];
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3 a = positions[at(vertices[i])] - origin;
    const Vec3 b = positions[at(vertices[(i + 1) % vertices.size()])] - origin;
    const double length = (b - a).norm();
    loop.length += length;
    loop.centre += 0.5 * length * (a + b);
    loop.area += 0.5 * a.cross(b);
  }
  loop.centre = origin + (loop.length > 0.0 ? Vec3(loop.centre / loop.length) : Vec3(Vec3::Zero()));
  loop.vertices = std::move(vertices);
  return loop;
}

double areaOf(const Triangle& triangle, const std::vector<Vec3>& positions) {
  const Vec3& a = positions[at(triangle[0])];
  return 0.5 * (positions[at(triangle[1])] - a).cross(positions[at(triangle[2])] - a).norm();
}

/// The index of its piece for each vertex; pieces are ordered by their lowest vertex.
std::vector<int> numberPieces(const ClothMesh& mesh, int& count) {
  DisjointSets sets(static_cast<int>(mesh.positions.size()));
  for (const Triangle& triangle : mesh.triangles) {
    sets.join(triangle[0], triangle[1]);
    sets.join(triangle[0], triangle[2]);
  }
  std::vector<int> number(mesh.positions.size(), -1);
  count = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const int root = sets.root(static_cast<int>(v));  // the lowest vertex of the piece
    number[v] = root == static_cast<int>(v) ? count++ : number[at(root)];
  }
  return number;
}

}  // namespace

bool ClothPieces::isOutline(const BoundaryLoop& loop) const {
  const ClothPiece& piece = pieces[at(loop.piece)];
  const double flatDisc = loop.length * loop.length / (4.0 * std::numbers::pi);
  return piece.loops == 1 && piece.eulerNumber == 1 && piece.area < 1.1 * flatDisc;
}

ClothPieces findPieces(const ClothMesh& mesh) {
  ClothPieces found;
  int count = 0;
  const std::vector<int> pieceOf = numberPieces(mesh, count);
  found.pieces.resize(at(count));
  for (std::size_t v = 0; v < pieceOf.size(); ++v) {
    ClothPiece& piece = found.pieces[at(pieceOf[v])];
    piece.vertices.push_back(static_cast<int>(v));
    ++piece.eulerNumber;
  }
  for (const Triangle& triangle : mesh.triangles) {
    ClothPiece& piece = found.pieces[at(pieceOf[at(triangle[0])])];
    piece.area += areaOf(triangle, mesh.positions);
    ++piece.eulerNumber;
  }
  const std::vector<Edge> sides = sortedSides(mesh.triangles);
  std::vector<Edge> boundary;
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last] == sides[first]) {
      ++last;
    }
    --found.pieces[at(pieceOf[at(sides[first].first)])].eulerNumber;
    if (last - first == 1) {
      boundary.push_back(sides[first]);
    }
  }
  BoundaryWalk walk(boundary);
  for (const int start : walk.vertices()) {
    for (std::vector<int> chain = walk.walkFrom(start); !chain.empty(); chain = walk.walkFrom(start)) {
      found.loops.push_back(measured(std::move(chain), mesh.positions));
      found.loops.back().piece = pieceOf[at(start)];
      ++found.pieces[at(pieceOf[at(start)])].loops;
    }
  }
  return found;
}

}  // namespace drape
