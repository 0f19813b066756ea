#include "sim/model/mesh_topology.hpp"

#include <gtest/gtest.h>
#include <span>
#include <vector>

namespace drape::sim {
namespace {

/// Two triangles on the edge from 1 to 2, and one of its own.
const std::vector<Triangle> twoAndOne{{0, 1, 2}, {2, 1, 3}, {6, 5, 4}};

TEST(MeshTopology, sortsTheEdges) {
  const MeshEdges mesh = edgesOf(twoAndOne, 7);
  EXPECT_EQ(mesh.edges, (std::vector<MeshEdge>{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}, {4, 5}, {4, 6}, {5, 6}}));
}

TEST(MeshTopology, listsTheSidesOnAnEdge) {
  const MeshEdges mesh = edgesOf(twoAndOne, 7);
  const std::span<const TriangleSide> sides = mesh.sides[2];
  ASSERT_EQ(sides.size(), 2U);
  EXPECT_EQ(sides[0].triangle, 0);
  EXPECT_EQ(sides[0].corner, 1);
  EXPECT_TRUE(sides[0].ascending);
  EXPECT_EQ(sides[1].triangle, 1);
  EXPECT_EQ(sides[1].corner, 0);
  EXPECT_FALSE(sides[1].ascending);
}

TEST(MeshTopology, findsTheBoundary) {
  EXPECT_EQ(boundaryEdges(edgesOf(twoAndOne, 7)),
            (std::vector<MeshEdge>{{0, 1}, {0, 2}, {1, 3}, {2, 3}, {4, 5}, {4, 6}, {5, 6}}));
}

TEST(MeshTopology, findsNoEdgeBetweenAVertexAndItself) {
  const std::vector<Triangle> triangles{{0, 0, 1}};
  const MeshEdges mesh = edgesOf(triangles, 2);
  EXPECT_EQ(mesh.edges, (std::vector<MeshEdge>{{0, 1}}));
  EXPECT_EQ(mesh.sides[0].size(), 2U);
}

TEST(MeshTopology, listsTheTrianglesOfAVertex) {
  const RaggedRows<int> triangles = trianglesOfVertices(twoAndOne, 8);
  EXPECT_EQ(std::vector<int>(triangles[1].begin(), triangles[1].end()), (std::vector<int>{0, 1}));
  EXPECT_EQ(std::vector<int>(triangles[4].begin(), triangles[4].end()), (std::vector<int>{2}));
  EXPECT_TRUE(triangles[7].empty());
}

TEST(MeshTopology, ordersComponentsByTheirLowestVertices) {
  const std::vector<Triangle> triangles{{6, 5, 2}, {1, 3, 0}};
  const ConnectedComponents components = componentsOf(triangles, 7);
  EXPECT_EQ(components.componentOf, (std::vector<int>{0, 0, 1, 0, 2, 1, 1}));
  EXPECT_EQ(components.lowestVertex, (std::vector<int>{0, 2, 4}));
  const RaggedRows<int> vertices = components.vertices();
  ASSERT_EQ(vertices.rowCount(), 3U);
  EXPECT_EQ(std::vector<int>(vertices[1].begin(), vertices[1].end()), (std::vector<int>{2, 5, 6}));
}

TEST(RaggedRows, haveNoRowsAtFirst) {
  EXPECT_EQ(RaggedRows<int>().rowCount(), 0U);
}

TEST(RaggedRows, keepTheOrderWithinARow) {
  const auto rows = RaggedRows<int>::collect(3, [](const auto& add) {
    add(2, 9);
    add(0, 5);
    add(2, 7);
  });
  EXPECT_EQ(rows.values(), (std::vector<int>{5, 9, 7}));
  EXPECT_EQ(rows[0].size(), 1U);
  EXPECT_TRUE(rows[1].empty());
  EXPECT_EQ(rows[2].size(), 2U);
}

}  // namespace
}  // namespace drape::sim
