#include "io/mesh_outliers.hpp"

#include "input_error.hpp"

#include <gtest/gtest.h>

namespace drape::io {
namespace {

/// A sheet of `side` x `side` vertices, 0.05 apart.
RawMesh sheet(int side) {
  RawMesh raw;
  for (int i = 0; i < side * side; ++i) {
    raw.positions.emplace_back(0.05 * (i % side), 0.05 * (i / side), 0.01 * (i % 3));
  }
  for (int row = 0; row + 1 < side; ++row) {
    for (int column = 0; column + 1 < side; ++column) {
      const int corner = row * side + column;
      raw.triangles.push_back({corner, corner + 1, corner + side});
      raw.triangles.push_back({corner + 1, corner + side + 1, corner + side});
    }
  }
  return raw;
}

std::string problemOf(const RawMesh& raw) {
  return inputErrorOf([&raw] { (void)weldMesh(raw, "mesh.obj", {}); });
}

TEST(MeshOutliers, findsOneVertexFarFromTheRest) {
  RawMesh raw = sheet(11);
  EXPECT_TRUE(findOutliers(raw.positions, raw.triangles).empty());
  for (const double away : {50.0, 1e5, 1e10}) {
    raw.positions[57].x() = away;
    EXPECT_EQ(findOutliers(raw.positions, raw.triangles), std::vector<int>{57}) << away;
  }
}

TEST(MeshOutliers, findsSeveral) {
  RawMesh raw = sheet(11);
  raw.positions[3] = Vec3(0, 1e8, 0);
  raw.positions[100] = Vec3(-2000, 0, 0);
  EXPECT_EQ(findOutliers(raw.positions, raw.triangles), (std::vector<int>{3, 100}));
}

TEST(MeshOutliers, leavesASecondObjectAlone) {
  RawMesh raw = sheet(11);
  RawMesh far = sheet(5);
  for (Triangle triangle : far.triangles) {
    for (int& vertex : triangle) {
      vertex += 121;
    }
    raw.triangles.push_back(triangle);
  }
  for (const Vec3& position : far.positions) {
    raw.positions.emplace_back(position + Vec3(1000, 0, 0));
  }
  EXPECT_TRUE(findOutliers(raw.positions, raw.triangles).empty());
}

TEST(MeshOutliers, areNamedAndRefused) {
  RawMesh raw = sheet(11);
  raw.positions[57].x() = 1e4;
  EXPECT_TRUE(contains(problemOf(raw), "lies 10 km from the rest of the mesh")) << problemOf(raw);
  EXPECT_TRUE(contains(problemOf(raw), "outliers=leave_out"));
  raw.positions[57].x() = 1e10;
  EXPECT_TRUE(contains(problemOf(raw), "km from the rest of the mesh")) << problemOf(raw);
}

TEST(MeshOutliers, areLeftOutWhenAskedWithTheirFacesOnly) {
  RawMesh raw = sheet(11);
  raw.positions[60].z() = -1e5;
  ImportOptions options;
  options.outliers = OutlierRule::LeaveOut;
  const MeshSummary summary = weldMesh(raw, "mesh.obj", options).summary;
  EXPECT_EQ(summary.outliers, 1);
  EXPECT_EQ(summary.triangles, 200 - 6);
  EXPECT_EQ(summary.vertices, 120);
  EXPECT_EQ(summary.isolatedVertices, 0);
  EXPECT_EQ(summary.degenerateFaces, 0);
  ASSERT_EQ(summary.warnings.size(), 1U);
  EXPECT_TRUE(contains(summary.warnings[0], "1 vertex lies far from all others"));
}

TEST(MeshOutliers, doNotCoarsenTheToleranceOfASecondObject) {
  RawMesh raw = sheet(11);
  const std::size_t faces = raw.triangles.size();
  const std::vector<Vec3> positions = raw.positions;
  for (const Vec3& position : positions) {
    raw.positions.emplace_back(position + Vec3(1e5, 0, 0));
  }
  for (std::size_t i = 0; i < faces; ++i) {
    const Triangle& face = raw.triangles[i];
    raw.triangles.push_back({face[0] + 121, face[1] + 121, face[2] + 121});
  }
  EXPECT_EQ(weldMesh(raw, "mesh.obj", {}).summary.triangles, 400) << "1e-6 of the diagonal is longer than two edges";
}

TEST(MeshOutliers, medianEdgeIgnoresEdgesWithoutLength) {
  EXPECT_DOUBLE_EQ(medianEdge({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}), 1.0);
  EXPECT_DOUBLE_EQ(medianEdge({{0, 0, 0}}, {{0, 0, 0}}), 0.0);
}

}  // namespace
}  // namespace drape::io
