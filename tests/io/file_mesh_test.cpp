#include "io/mesh_import.hpp"

#include <gtest/gtest.h>
#include <string>

namespace drape::io {
namespace {

ImportedMesh importedFrom(const std::string& name, const std::string& text) {
  return importMeshFromMemory(name, text, {});
}

/// Each vertex of the file is where its vertex of the cloth is.
void expectPlaces(const ImportedMesh& mesh, int outside = 0) {
  int missing = 0;
  for (std::size_t v = 0; v < mesh.file->positions.size(); ++v) {
    const int particle = mesh.file->particle[v];
    if (particle < 0) {
      ++missing;
      continue;
    }
    EXPECT_LT((mesh.cloth.positions[particle] - mesh.file->positions[v]).norm(), 1e-6) << "vertex " << v;
  }
  EXPECT_EQ(missing, outside);
}

TEST(FileMesh, keepsTheVerticesAndPolygonsOfAnObjInTheirOrder) {
  // The faces use the vertices in another order than the file has them, vertex 2 lies where vertex 5 does, and vertex 3
  // belongs to no face.
  const ImportedMesh mesh = importedFrom("a.obj",
                                         "v 1 1 0\nv 1 0 0\nv 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                                         "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.25 0.5\n"
                                         "f 4/1 2/2 1/3 6/4\nf 5/5 -2/2 -1\nf 5 -1 1\n");
  ASSERT_TRUE(mesh.file);
  ASSERT_EQ(mesh.file->positions.size(), 8U);
  EXPECT_EQ(mesh.file->positions[7], Vec3(2, 1, 0));
  EXPECT_EQ(mesh.file->particle[1], mesh.file->particle[4]);
  EXPECT_EQ(mesh.file->particle[2], -1);
  expectPlaces(mesh, 1);
  EXPECT_EQ(mesh.file->faceEnds, (std::vector<int>{4, 7, 10}));
  EXPECT_EQ(mesh.file->corners, (std::vector<int>{3, 1, 0, 5, 4, 6, 7, 4, 7, 0}));
  EXPECT_EQ(mesh.file->uvCorners, (std::vector<int>{0, 1, 2, 3, 4, 1, -1, -1, -1, -1}));
  ASSERT_EQ(mesh.file->uvs.size(), 5U);
  EXPECT_EQ(mesh.file->uvs[4], Vec2(0.25, 0.5));
}

TEST(FileMesh, dividesTheVerticesOfAnObjByTheirWeight) {
  const ImportedMesh mesh = importedFrom("a.obj", "v 0 0 0 2\nv 2 0 0 2\nv 0 2 0 2\nf 1 2 3\n");
  EXPECT_EQ(mesh.file->positions[1], Vec3(1, 0, 0));
  expectPlaces(mesh);
}

TEST(FileMesh, keepsTheOrderOfAPly) {
  const ImportedMesh mesh = importedFrom("a.ply",
                                         "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                                         "property float z\nproperty float s\nproperty float t\nelement face 2\n"
                                         "property list uchar int vertex_indices\nend_header\n"
                                         "7 7 7 0 0\n1 1 0 1 1\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 2 3 1\n3 2 1 4\n");
  ASSERT_EQ(mesh.file->positions.size(), 5U);
  expectPlaces(mesh, 1);
  EXPECT_EQ(mesh.file->particle[0], -1);
  EXPECT_EQ(mesh.file->corners, (std::vector<int>{2, 3, 1, 2, 1, 4}));
  ASSERT_EQ(mesh.file->uvs.size(), 5U);
  EXPECT_EQ(mesh.file->uvs[3], Vec2(1, 0));
  EXPECT_EQ(mesh.file->uvCorners, mesh.file->corners);
}

TEST(FileMesh, followsVerticesThatTheWeldJoins) {
  // Vertex 4 is a nanometre away from vertex 2.
  const ImportedMesh mesh =
      importedFrom("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1.000000001 0 0\nv 1 1 0\nf 1 2 3\nf 4 5 3\n");
  EXPECT_EQ(mesh.cloth.positions.size(), 4U);
  EXPECT_EQ(mesh.file->particle[1], mesh.file->particle[3]);
  expectPlaces(mesh);
}

TEST(FileMesh, isTheMeshOfTheLibraryForFormatsWithoutVertices) {
  const ImportedMesh mesh = importedFrom("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
  EXPECT_EQ(mesh.file->positions.size(), 4U);
  EXPECT_EQ(mesh.file->faceEnds.size(), 2U);
  expectPlaces(mesh);
}

TEST(FileMesh, isLeftOutForBodies) {
  ImportOptions options;
  options.use = MeshUse::Body;
  EXPECT_FALSE(importMeshFromMemory("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", options).file);
}

}  // namespace
}  // namespace drape::io
