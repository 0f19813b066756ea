#include "io/topology_counts.hpp"

#include <gtest/gtest.h>

namespace drape::io {
namespace {

/// A strip of quads around a cylinder, `count` of them.
std::vector<Triangle> tube(int count) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    triangles.push_back({2 * i, 2 * next, 2 * i + 1});
    triangles.push_back({2 * next, 2 * next + 1, 2 * i + 1});
  }
  return triangles;
}

TEST(TopologyCounts, countsTheEdgesOfATriangle) {
  const TopologyCounts topology = countTopology(3, {{0, 1, 2}});
  EXPECT_EQ(topology.edges, 3);
  EXPECT_EQ(topology.boundaryLoops, 1);
  EXPECT_EQ(topology.components, 1);
}

TEST(TopologyCounts, findsNoBorderOnAClosedMesh) {
  const TopologyCounts topology = countTopology(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  EXPECT_EQ(topology.edges, 6);
  EXPECT_EQ(topology.boundaryLoops, 0);
  EXPECT_EQ(topology.misorientedEdges, 0);
}

TEST(TopologyCounts, findsTheTwoBordersOfATube) {
  const TopologyCounts topology = countTopology(12, tube(6));
  EXPECT_EQ(topology.boundaryLoops, 2);
  EXPECT_EQ(topology.components, 1);
  EXPECT_EQ(topology.edges, 24);
}

TEST(TopologyCounts, countsPiecesThatShareNoEdge) {
  const TopologyCounts topology = countTopology(7, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(topology.components, 3) << "two triangles and a vertex of its own";
  EXPECT_EQ(topology.boundaryLoops, 2);
}

TEST(TopologyCounts, findsEdgesWithMoreThanTwoFaces) {
  const TopologyCounts topology = countTopology(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_EQ(topology.nonManifoldEdges, 1);
  EXPECT_EQ(topology.misorientedEdges, 0) << "what 'the same direction' means is clear for two faces only";
}

TEST(TopologyCounts, findsFacesThatRunTheSameWayAlongAnEdge) {
  EXPECT_EQ(countTopology(4, {{0, 1, 2}, {0, 1, 3}}).misorientedEdges, 1);
  EXPECT_EQ(countTopology(4, {{0, 1, 2}, {1, 0, 3}}).misorientedEdges, 0);
}

}  // namespace
}  // namespace drape::io
