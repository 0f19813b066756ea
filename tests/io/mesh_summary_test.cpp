#include "io/mesh_import.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape::io {
namespace {

RawMesh square(double side) {
  RawMesh raw;
  raw.positions = {{0, 0, 0}, {side / 2, 0, 0}, {0, side, 0}, {side / 2, side, 0}};
  raw.triangles = {{0, 1, 2}, {1, 3, 2}};
  return raw;
}

bool warns(const ImportedMesh& mesh, const std::string& part) {
  return std::any_of(mesh.summary.warnings.begin(), mesh.summary.warnings.end(),
                     [&part](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

TEST(MeshSummary, hasNothingToWarnAboutOnACleanGarment) {
  EXPECT_TRUE(weldMesh(square(1.0), "mesh.obj", {}).summary.warnings.empty());
}

TEST(MeshSummary, warnsOfDroppedParts) {
  RawMesh raw = square(1.0);
  raw.positions.emplace_back(0.3, 0.3, 0.0);
  raw.triangles.push_back({0, 0, 1});
  raw.triangles.push_back({2, 1, 0});
  raw.facesSkipped = 3;
  const ImportedMesh mesh = weldMesh(raw, "mesh.obj", {});
  EXPECT_TRUE(warns(mesh, "1 face has no area"));
  EXPECT_TRUE(warns(mesh, "1 face repeats"));
  EXPECT_TRUE(warns(mesh, "3 points and lines"));
  EXPECT_TRUE(warns(mesh, "1 vertex belongs to no face"));
}

TEST(MeshSummary, warnsOfMeshesThatDoNotHangTogetherWell) {
  RawMesh raw = square(1.0);
  raw.positions.insert(raw.positions.end(), {{0.2, 0.9, 0.5}, {2, 0, 0}, {3, 0, 0}, {2, 1, 0}, {3, 1, 0}});
  raw.triangles.push_back({1, 2, 4});
  raw.triangles.push_back({5, 6, 7});
  raw.triangles.push_back({6, 7, 8});
  const ImportedMesh mesh = weldMesh(raw, "mesh.obj", {});
  EXPECT_EQ(mesh.summary.nonManifoldEdges, 1);
  EXPECT_EQ(mesh.summary.misorientedEdges, 1);
  EXPECT_EQ(mesh.summary.components, 2);
  EXPECT_TRUE(warns(mesh, "more than two faces"));
  EXPECT_TRUE(warns(mesh, "opposite sides"));
  EXPECT_TRUE(warns(mesh, "2 separate pieces"));
  ImportOptions ofBody;
  ofBody.use = MeshUse::Body;
  EXPECT_TRUE(warns(weldMesh(raw, "mesh.obj", ofBody), "opposite sides: the mesh counts as open"));
}

TEST(MeshSummary, warnsOfSliversWithTheirPlace) {
  RawMesh raw;
  for (int i = 0; i < 25; ++i) {
    raw.positions.emplace_back(10 * (i % 5), 10 * (i / 5), 0.0);
  }
  raw.positions[12] = Vec3(20, 10.001, 0);
  for (int i = 0; i < 20; ++i) {
    if (i % 5 < 4) {
      raw.triangles.push_back({i, i + 1, i + 5});
      raw.triangles.push_back({i + 1, i + 6, i + 5});
    }
  }
  ImportOptions options;
  options.metresPerUnit = 0.1;
  const ImportedMesh mesh = weldMesh(raw, "mesh.obj", options);
  EXPECT_EQ(mesh.summary.shortEdges, 1);
  EXPECT_EQ(mesh.summary.isolatedVertices, 0);
  EXPECT_EQ(mesh.summary.vertices, 24);
  EXPECT_EQ(mesh.summary.triangles, 30);
  EXPECT_EQ(mesh.summary.nonManifoldEdges, 0);
  EXPECT_EQ(mesh.summary.boundaryLoops, 1);
  EXPECT_TRUE(warns(mesh, "1 edge was less than a thousandth"));
  EXPECT_TRUE(warns(mesh, "at (20, 10, 0) in the file"));
}

TEST(MeshSummary, doesNotRepairTheThinPlateOfABody) {
  RawMesh raw;
  for (const double z : {0.0, 0.0002}) {
    raw.positions.insert(raw.positions.end(), {{0, 0, z}, {0.4, 0, z}, {0.4, 0.3, z}, {0, 0.3, z}});
  }
  for (int side = 0; side < 4; ++side) {
    const int next = (side + 1) % 4;
    raw.triangles.insert(raw.triangles.end(), {{side, next, next + 4}, {side, next + 4, side + 4}});
  }
  raw.triangles.insert(raw.triangles.end(), {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}});
  ImportOptions options;
  options.use = MeshUse::Body;
  const ImportedMesh mesh = weldMesh(raw, "plate.obj", options);
  EXPECT_EQ(mesh.summary.vertices, 8);
  EXPECT_EQ(mesh.summary.triangles, 12);
  EXPECT_TRUE(mesh.summary.warnings.empty());
}

TEST(MeshSummary, doesNotWarnABodyOfItsSizeOrItsPieces) {
  RawMesh raw = square(63.0);
  raw.positions.insert(raw.positions.end(), {{200, 0, 0}, {300, 0, 0}, {200, 10, 0}});
  raw.triangles.push_back({4, 5, 6});
  ImportOptions options;
  options.use = MeshUse::Body;
  EXPECT_TRUE(weldMesh(raw, "mesh.obj", options).summary.warnings.empty());
}

TEST(MeshSummary, isDescribedLineByLineWithoutItsWarnings) {
  RawMesh raw = square(63.0);
  raw.positions.emplace_back(30.0, 30.0, 0.0);
  const MeshSummary summary = weldMesh(raw, "big.obj", {}).summary;
  ASSERT_FALSE(summary.warnings.empty());
  const std::vector<std::string> lines = describe(summary);
  EXPECT_NE(lines.front().find("big.obj"), std::string::npos);
  EXPECT_NE(lines.back().find("size"), std::string::npos);
  EXPECT_EQ(lines[1], "vertices:    4 (5 as read from the file)");
  EXPECT_EQ(describe(weldMesh(square(1.0), "plain.obj", {}).summary)[1], "vertices:    4") << "nothing was joined";
}

}  // namespace
}  // namespace drape::io
