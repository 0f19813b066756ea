#include "scene/boundary_loops.hpp"

#include "sim/model/mesh_topology.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace drape::scene {
namespace {

/// The boundary edges at each boundary vertex, with a flag for visited edges.
class BoundaryWalk {
 public:
  explicit BoundaryWalk(const std::vector<sim::MeshEdge>& edges) : edges_(edges), walked_(edges.size(), false) {
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
      edgesAt_[edges[edge].a].push_back(edge);
      edgesAt_[edges[edge].b].push_back(edge);
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
        return edges_[edge].a == here ? edges_[edge].b : edges_[edge].a;
      }
    }
    return -1;
  }

  const std::vector<sim::MeshEdge>& edges_;
  std::vector<bool> walked_;
  std::map<int, std::vector<std::size_t>> edgesAt_;
};

/// The smallest extent of points over the middle one [-].
double thicknessOf(const std::vector<int>& vertices, const std::vector<Vec3>& positions) {
  Vec3 mean = Vec3::Zero();
  for (const int vertex : vertices) {
    mean += positions[vertex] / static_cast<double>(vertices.size());
  }
  Mat3 spread = Mat3::Zero();
  for (const int vertex : vertices) {
    const Vec3 off = positions[vertex] - mean;
    spread += off * off.transpose();
  }
  const Vec3 sizes = Eigen::SelfAdjointEigenSolver<Mat3>(spread, Eigen::EigenvaluesOnly).eigenvalues();
  return sizes[1] > 0.0 ? std::sqrt(std::max(0.0, sizes[0]) / sizes[1]) : 0.0;
}

BoundaryLoop measured(std::vector<int> vertices, const std::vector<Vec3>& positions) {
  BoundaryLoop loop;
  const Vec3& origin = positions[vertices.front()];
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3 a = positions[vertices[i]] - origin;
    const Vec3 b = positions[vertices[(i + 1) % vertices.size()]] - origin;
    const double length = (b - a).norm();
    loop.length += length;
    loop.centre += 0.5 * length * (a + b);
    loop.area += 0.5 * a.cross(b);
    loop.box.extend(positions[vertices[i]]);
  }
  loop.centre = origin + (loop.length > 0.0 ? Vec3(loop.centre / loop.length) : Vec3(Vec3::Zero()));
  loop.thickness = thicknessOf(vertices, positions);
  loop.vertices = std::move(vertices);
  return loop;
}

double areaOf(const Triangle& triangle, const std::vector<Vec3>& positions) {
  const Vec3& a = positions[triangle[0]];
  return 0.5 * (positions[triangle[1]] - a).cross(positions[triangle[2]] - a).norm();
}

}  // namespace

bool ClothPieces::isOutline(const BoundaryLoop& loop) const {
  const ClothPiece& piece = pieces[loop.piece];
  const double flatDisc = loop.length * loop.length / (4.0 * std::numbers::pi);
  if (piece.loops == 1) {
    return piece.eulerNumber == 1 && piece.area < 1.1 * flatDisc;
  }
  constexpr double span = 0.8;   // of the piece; the ends of a tube do not extend from one to the other
  constexpr double round = 0.7;  // of the circle with that circumference; the end of a slanted short tube is rounder
  const bool spansPiece = (loop.box.sizes().array() >= span * piece.box.sizes().array()).all();
  constexpr double narrow = 0.2;
  constexpr double thick = 0.3;
  return (spansPiece && loop.area.norm() < round * flatDisc) ||
         (loop.thickness > thick && loop.area.norm() < narrow * flatDisc);
}

ClothPieces findPieces(const sim::ClothMesh& mesh) {
  ClothPieces found;
  const sim::ConnectedComponents components = sim::componentsOf(mesh.triangles, mesh.positions.size());
  const std::vector<int>& pieceOf = components.componentOf;
  found.pieces.resize(components.count());
  for (std::size_t v = 0; v < pieceOf.size(); ++v) {
    ClothPiece& piece = found.pieces[pieceOf[v]];
    piece.vertices.push_back(static_cast<int>(v));
    piece.box.extend(mesh.positions[v]);
    ++piece.eulerNumber;
  }
  for (const Triangle& triangle : mesh.triangles) {
    ClothPiece& piece = found.pieces[pieceOf[triangle[0]]];
    piece.area += areaOf(triangle, mesh.positions);
    ++piece.eulerNumber;
  }
  const sim::MeshEdges topology = sim::edgesOf(mesh.triangles, mesh.positions.size());
  for (const sim::MeshEdge& edge : topology.edges) {
    --found.pieces[pieceOf[edge.a]].eulerNumber;
  }
  const std::vector<sim::MeshEdge> boundary = sim::boundaryEdges(topology);
  BoundaryWalk walk(boundary);
  for (const int start : walk.vertices()) {
    for (std::vector<int> chain = walk.walkFrom(start); !chain.empty(); chain = walk.walkFrom(start)) {
      found.loops.push_back(measured(std::move(chain), mesh.positions));
      found.loops.back().piece = pieceOf[start];
      ++found.pieces[pieceOf[start]].loops;
    }
  }
  return found;
}

}  // namespace drape::scene
