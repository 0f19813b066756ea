#include "dressing/closed_body.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace drape::dressing {
namespace {

double areaOf(const sim::ClothMesh& mesh, std::size_t firstTriangle, std::size_t lastTriangle) {
  double area = 0.0;
  for (std::size_t t = firstTriangle; t < lastTriangle; ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    area += 0.5 * (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).norm();
  }
  return area;
}

/// The sides of triangles that no side in the opposite direction meets, by their first vertex. As many end at a vertex
/// as begin there, also where more than two triangles share an edge.
class OpenSides {
 public:
  explicit OpenSides(const std::vector<Triangle>& triangles) {
    std::map<std::pair<int, int>, int> excess;  // sides from the lower vertex to the higher one, minus those back
    for (const Triangle& triangle : triangles) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const int from = triangle[corner];
        const int to = triangle[(corner + 1) % 3];
        excess[std::minmax(from, to)] += from < to ? 1 : -1;
      }
    }
    for (const auto& [edge, count] : excess) {
      if (count != 0) {
        const auto& [from, to] = count > 0 ? edge : std::pair(edge.second, edge.first);
        next_[from].insert(next_[from].end(), static_cast<std::size_t>(std::abs(count)), to);
      }
    }
  }

  [[nodiscard]] bool isEmpty() const { return next_.empty(); }

  /// Removes a closed chain that visits no vertex twice. @return its vertices in the direction of its sides
  std::vector<int> takeChain() {
    std::vector<int> chain{next_.begin()->first};
    while (true) {
      const int next = next_.at(chain.back()).back();
      const auto visited = std::ranges::find(chain, next);
      if (visited != chain.end()) {
        chain.erase(chain.begin(), visited);
        remove(chain);
        return chain;
      }
      chain.push_back(next);
    }
  }

 private:
  void remove(const std::vector<int>& chain) {
    for (const int vertex : chain) {
      const auto sides = next_.find(vertex);
      sides->second.pop_back();
      if (sides->second.empty()) {
        next_.erase(sides);
      }
    }
  }

  std::map<int, std::vector<int>> next_;
};

void fill(const std::vector<int>& chain, sim::ClothMesh& mesh) {
  if (chain.size() == 3) {
    mesh.triangles.push_back({chain[2], chain[1], chain[0]});
    return;
  }
  Vec3 mean = Vec3::Zero();
  for (const int vertex : chain) {
    mean += mesh.positions[vertex] / static_cast<double>(chain.size());
  }
  const auto middle = static_cast<int>(mesh.positions.size());
  mesh.positions.push_back(mean);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    mesh.triangles.push_back({chain[(i + 1) % chain.size()], chain[i], middle});
  }
}

}  // namespace

ClosedBody closedBody(sim::ClothMesh body) {
  ClosedBody closed{std::move(body), 0, 0.0};
  sim::ClothMesh& mesh = closed.mesh;
  const std::size_t given = mesh.triangles.size();
  OpenSides open(mesh.triangles);
  while (!open.isEmpty()) {
    const std::vector<int> chain = open.takeChain();
    if (chain.size() > 2) {  // two sides between the same vertices meet without a filling
      fill(chain, mesh);
      ++closed.holes;
    }
  }
  const double givenArea = areaOf(mesh, 0, given);
  closed.addedArea = givenArea > 0.0 ? areaOf(mesh, given, mesh.triangles.size()) / givenArea : 0.0;
  return closed;
}

}  // namespace drape::dressing
