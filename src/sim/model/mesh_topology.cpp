#include "sim/model/mesh_topology.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace drape::sim {
namespace {

/// A side, stored at the lower vertex of its edge.
struct SideAtVertex {
  int higher = 0;  // the other vertex
  TriangleSide side;
};

RaggedRows<SideAtVertex> sidesAtLowerVertices(std::span<const Triangle> triangles, std::size_t vertexCount) {
  return RaggedRows<SideAtVertex>::collect(vertexCount, [&](const auto& add) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (int corner = 0; corner < 3; ++corner) {
        const int from = triangles[t][corner];
        const int to = triangles[t][(corner + 1) % 3];
        if (from != to) {
          add(std::min(from, to), {std::max(from, to), {static_cast<int>(t), corner, from < to}});
        }
      }
    }
  });
}

}  // namespace

MeshEdges edgesOf(std::span<const Triangle> triangles, std::size_t vertexCount) {
  RaggedRows<SideAtVertex> sides = sidesAtLowerVertices(triangles, vertexCount);
  MeshEdges mesh;
  std::vector<int> sidesOfEdge;
  std::vector<TriangleSide> sorted;
  sorted.reserve(sides.values().size());
  for (std::size_t lower = 0; lower < vertexCount; ++lower) {
    const std::span<SideAtVertex> row = sides[lower];
    std::sort(row.begin(), row.end(), [](const SideAtVertex& x, const SideAtVertex& y) {
      return std::tie(x.higher, x.side.triangle, x.side.corner) < std::tie(y.higher, y.side.triangle, y.side.corner);
    });
    for (const SideAtVertex& each : row) {
      const MeshEdge edge{static_cast<int>(lower), each.higher};
      if (mesh.edges.empty() || mesh.edges.back() != edge) {
        mesh.edges.push_back(edge);
        sidesOfEdge.push_back(0);
      }
      ++sidesOfEdge.back();
      sorted.push_back(each.side);
    }
  }
  mesh.sides = RaggedRows<TriangleSide>(sidesOfEdge, std::move(sorted));
  return mesh;
}

std::vector<MeshEdge> boundaryEdges(const MeshEdges& mesh) {
  std::vector<MeshEdge> boundary;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    if (mesh.onBoundary(e)) {
      boundary.push_back(mesh.edges[e]);
    }
  }
  return boundary;
}

RaggedRows<int> trianglesOfVertices(std::span<const Triangle> triangles, std::size_t vertexCount) {
  return RaggedRows<int>::collect(vertexCount, [&](const auto& add) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (const int v : triangles[t]) {
        add(v, static_cast<int>(t));
      }
    }
  });
}

ConnectedComponents componentsOf(DisjointSets& sets) {
  ConnectedComponents components;
  components.componentOf.resize(sets.size());
  for (int v = 0; v < static_cast<int>(sets.size()); ++v) {
    const int root = sets.root(v);  // the lowest vertex of the set
    if (root == v) {
      components.componentOf[v] = components.count();
      components.lowestVertex.push_back(v);
    } else {
      components.componentOf[v] = components.componentOf[root];
    }
  }
  return components;
}

ConnectedComponents componentsOf(std::span<const Triangle> triangles, std::size_t vertexCount) {
  DisjointSets sets(vertexCount);
  for (const Triangle& triangle : triangles) {
    joinCorners(triangle, sets);
  }
  return componentsOf(sets);
}

}  // namespace drape::sim
