#include "io/short_edges.hpp"

#include <gtest/gtest.h>

namespace drape::io {
namespace {

/// A square of 2 x 2 cells, rows from y = 0, with the vertex `moved` at `place`.
struct Sheet {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;

  Sheet(std::size_t moved, const Vec3& place) {
    for (int i = 0; i < 9; ++i) {
      positions.emplace_back(i % 3, i / 3, 0.0);
    }
    positions[moved] = place;
    for (const int corner : {0, 1, 3, 4}) {
      triangles.push_back({corner, corner + 1, corner + 3});
      triangles.push_back({corner + 1, corner + 4, corner + 3});
    }
  }
};

TEST(ShortEdges, leavesAnOrdinaryMeshAlone) {
  const Sheet sheet(4, Vec3(1, 1, 0));
  const ShortEdges edges = collapseShortEdges(sheet.positions, sheet.triangles, 1e-3);
  EXPECT_FALSE(edges.where.has_value());
  EXPECT_EQ(edges.collapsed, 0);
}

TEST(ShortEdges, mergesTheEndsIntoTheLowerNumber) {
  const Sheet sheet(4, Vec3(1, 1e-5, 0));
  const ShortEdges edges = collapseShortEdges(sheet.positions, sheet.triangles, 1e-3);
  EXPECT_EQ(edges.collapsed, 1);
  EXPECT_EQ(edges.kept, 0);
  EXPECT_EQ(edges.replacement, (std::vector<int>{0, 1, 2, 3, 1, 5, 6, 7, 8}));
  EXPECT_EQ(edges.where, Vec3(1, 0, 0));
}

TEST(ShortEdges, mergesAChainOfShortEdges) {
  std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1e-5, 0}, {1, 2e-5, 0}, {0, 1, 0}, {2, 0.5, 0}};
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {1, 5, 2}, {2, 5, 3}, {3, 5, 4}};
  const ShortEdges edges = collapseShortEdges(positions, triangles, 1e-3);
  EXPECT_EQ(edges.collapsed, 2);
  EXPECT_EQ(edges.replacement, (std::vector<int>{0, 1, 1, 1, 4, 5}));
}

TEST(ShortEdges, keepsAnInnerEdgeBetweenTwoBorders) {
  // Two triangles share a short edge with both ends on the border: a collapse would leave a single point between two
  // borders.
  const std::vector<Vec3> positions{{0, 0, 0}, {0, 1e-5, 0}, {1, 0, 0}, {-1, 0, 0}, {1, 1, 0}, {-1, 1, 0}};
  const std::vector<Triangle> triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 4}, {1, 5, 3}};
  const ShortEdges edges = collapseShortEdges(positions, triangles, 1e-3);
  EXPECT_EQ(edges.collapsed, 0);
  EXPECT_EQ(edges.kept, 1);
}

TEST(ShortEdges, keepsAnEdgeWhoseCollapseWouldTurnAFace) {
  // Vertex 2 is on one side of the line through 0 and 1, and would be on the other side of the line from vertex 3.
  const Sheet sheet(4, Vec3(1, 1e-5, 0));
  std::vector<Vec3> positions = sheet.positions;
  positions[5] = Vec3(1.5, 0.5e-5, 0);  // below vertex 4, above vertex 1
  positions[2] = Vec3(2, -1, 0);
  const ShortEdges edges = collapseShortEdges(positions, sheet.triangles, 1e-3);
  EXPECT_EQ(edges.collapsed + edges.kept, 1);
}

TEST(ShortEdges, keepsATriangleThatStandsAlone) {
  const ShortEdges edges = collapseShortEdges({{0, 0, 0}, {1e-5, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, 1e-3);
  EXPECT_EQ(edges.collapsed, 0);
  EXPECT_EQ(edges.kept, 1);
}

}  // namespace
}  // namespace drape::io
