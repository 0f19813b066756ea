#include "input_error.hpp"
#include "io/mesh_import.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace drape::io {
namespace {

/// Two triangles of a unit square that meet along its diagonal, each with its own vertices, as at a texture seam.
RawMesh seamSquare() {
  RawMesh raw;
  raw.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  raw.uvs = {{0, 0}, {1, 0}, {0, 1}, {3, 0}, {3, 1}, {2, 1}};
  raw.triangles = {{0, 1, 2}, {3, 4, 5}};
  return raw;
}

ImportedMesh weld(const RawMesh& raw) {
  return weldMesh(raw, "mesh.obj", {});
}

TEST(MeshWeld, joinsVerticesOverATextureSeam) {
  const ImportedMesh mesh = weld(seamSquare());
  EXPECT_EQ(mesh.cloth.positions.size(), 4U);
  EXPECT_EQ(mesh.summary.verticesInFile, 6);
  EXPECT_EQ(mesh.summary.springs, 5);
  EXPECT_EQ(mesh.summary.components, 1);
}

TEST(MeshWeld, keepsTheTextureSplitAtTheSeam) {
  const ImportedMesh mesh = weld(seamSquare());
  ASSERT_EQ(mesh.render.particle.size(), 6U);
  EXPECT_EQ(mesh.render.uvs[3], Vec2(3, 0));
  EXPECT_EQ(mesh.render.particle[1], mesh.render.particle[3]);
}

TEST(MeshWeld, numbersParticlesInTheOrderOfTheirFirstAppearance) {
  const ImportedMesh mesh = weld(seamSquare());
  EXPECT_EQ(mesh.cloth.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.cloth.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}));
}

TEST(MeshWeld, drawsTheTrianglesOfTheClothOneByOne) {
  RawMesh raw = seamSquare();
  raw.triangles.insert(raw.triangles.begin(), {{0, 0, 1}, {0, 1, 2}, {2, 1, 0}});
  const ImportedMesh mesh = weld(raw);
  ASSERT_EQ(mesh.render.triangles.size(), mesh.cloth.triangles.size());
  for (std::size_t t = 0; t < mesh.cloth.triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto vertex = static_cast<std::size_t>(mesh.render.triangles[t][corner]);
      EXPECT_EQ(mesh.render.particle[vertex], mesh.cloth.triangles[t][corner]);
    }
  }
}

TEST(MeshWeld, joinsVerticesWithinTheToleranceAndNoOthers) {
  RawMesh raw = seamSquare();
  raw.positions[3].x() += 1e-5;
  ImportOptions options;
  options.weldTolerance = 1e-6;
  EXPECT_EQ(weldMesh(raw, "mesh.obj", options).summary.vertices, 5);
  options.weldTolerance = 1e-5;
  EXPECT_EQ(weldMesh(raw, "mesh.obj", options).summary.vertices, 4);
  options.weldTolerance = 0.0;
  EXPECT_EQ(weldMesh(seamSquare(), "mesh.obj", options).summary.vertices, 4);
}

TEST(MeshWeld, findsNearVerticesInEveryDirection) {
  for (int direction = 0; direction < 27; ++direction) {
    const Vec3 step(direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1);
    RawMesh raw;
    for (const double x : {0.1, 0.2, 0.3, 0.4, 0.5}) {
      const int first = static_cast<int>(raw.positions.size());
      for (const Vec3& corner : {Vec3(x, 0, 0), Vec3(x + 0.05, 0.3, 0), Vec3(x, 0.3, 0.7)}) {
        raw.positions.push_back(corner);
        raw.positions.emplace_back(corner + 4e-7 * step);
      }
      raw.triangles.push_back({first, first + 2, first + 4});
      raw.triangles.push_back({first + 5, first + 3, first + 1});
    }
    const MeshSummary summary = weld(raw).summary;
    EXPECT_EQ(summary.vertices, 15) << "direction " << direction;
    EXPECT_EQ(summary.duplicateFaces, 5) << "direction " << direction;
  }
}

TEST(MeshWeld, givesTheSameAnswerTwice) {
  const ImportedMesh first = weld(seamSquare());
  const ImportedMesh second = weld(seamSquare());
  EXPECT_EQ(first.cloth.positions, second.cloth.positions);
  EXPECT_EQ(first.cloth.triangles, second.cloth.triangles);
  EXPECT_EQ(first.render.uvs, second.render.uvs);
}

TEST(MeshWeld, dropsFacesWithARepeatedVertex) {
  RawMesh raw = seamSquare();
  raw.triangles.push_back({1, 3, 4});  // two of the three are one particle
  const ImportedMesh mesh = weld(raw);
  EXPECT_EQ(mesh.summary.degenerateFaces, 1);
  EXPECT_EQ(mesh.cloth.triangles.size(), 2U);
}

TEST(MeshWeld, dropsFacesWithoutArea) {
  RawMesh raw = seamSquare();
  raw.positions.emplace_back(0.5, 0.0, 0.0);
  raw.uvs.emplace_back(0.0, 0.0);
  raw.triangles.push_back({0, 6, 1});
  const ImportedMesh mesh = weld(raw);
  EXPECT_EQ(mesh.summary.degenerateFaces, 1);
  EXPECT_EQ(mesh.summary.isolatedVertices, 1);
  EXPECT_EQ(mesh.cloth.positions.size(), 4U);
}

TEST(MeshWeld, keepsSlivers) {
  RawMesh raw = seamSquare();
  raw.positions.emplace_back(0.5, -1e-4, 0.0);
  raw.uvs.emplace_back(0.0, 0.0);
  raw.triangles.push_back({0, 6, 1});
  EXPECT_EQ(weld(raw).summary.triangles, 3);
}

TEST(MeshWeld, dropsFacesThatRepeatOthersInAnyOrder) {
  RawMesh raw = seamSquare();
  raw.triangles.push_back({1, 2, 0});
  raw.triangles.push_back({0, 2, 1});
  raw.triangles.push_back({5, 3, 4});
  const ImportedMesh mesh = weld(raw);
  EXPECT_EQ(mesh.summary.duplicateFaces, 3);
  EXPECT_EQ(mesh.cloth.triangles.size(), 2U);
}

TEST(MeshWeld, dropsVerticesWithoutAFaceAndNumbersTheOthersAnew) {
  RawMesh raw = seamSquare();
  raw.positions.insert(raw.positions.begin(), Vec3(100, 100, 100));
  raw.uvs.insert(raw.uvs.begin(), Vec2(0, 0));
  for (Triangle& triangle : raw.triangles) {
    for (int& vertex : triangle) {
      ++vertex;
    }
  }
  const ImportedMesh mesh = weld(raw);
  EXPECT_EQ(mesh.summary.isolatedVertices, 1);
  EXPECT_EQ(mesh.cloth.positions.front(), Vec3(0, 0, 0));
  EXPECT_DOUBLE_EQ(mesh.summary.size[0], 1.0);
}

TEST(MeshWeld, turnsTheFilesUnitIntoMetres) {
  ImportOptions options;
  options.metresPerUnit = 0.01;
  const ImportedMesh mesh = weldMesh(seamSquare(), "mesh.obj", options);
  EXPECT_DOUBLE_EQ(mesh.cloth.positions[3].x(), 0.01);
  EXPECT_DOUBLE_EQ(mesh.summary.size[1], 0.01);
}

TEST(MeshWeld, laysOutTheFabricInMetresWhenTheFileHasNoTextureCoordinates) {
  RawMesh raw = seamSquare();
  raw.uvs.clear();
  ImportOptions options;
  options.metresPerUnit = 0.5;
  const RenderMesh render = weldMesh(raw, "mesh.obj", options).render;
  ASSERT_EQ(render.uvs.size(), 4U);
  EXPECT_DOUBLE_EQ((render.uvs[1] - render.uvs[0]).norm(), 0.5);
}

TEST(MeshWeld, laysEachSideOfABoxFlatWithoutStretching) {
  RawMesh raw;
  raw.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  raw.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}};
  const ImportedMesh mesh = weld(raw);
  for (const Triangle& t : mesh.render.triangles) {
    const auto at = [](int index) { return static_cast<std::size_t>(index); };
    for (const std::size_t corner : {0U, 1U, 2U}) {
      const int a = t[corner];
      const int b = t[(corner + 1) % 3];
      const Vec3& from = mesh.cloth.positions[at(mesh.render.particle[at(a)])];
      const Vec3& to = mesh.cloth.positions[at(mesh.render.particle[at(b)])];
      EXPECT_DOUBLE_EQ((mesh.render.uvs[at(a)] - mesh.render.uvs[at(b)]).norm(), (from - to).norm());
    }
  }
}

TEST(MeshWeld, refusesMeshesThatCannotBeUsed) {
  RawMesh raw = seamSquare();
  raw.positions[4].z() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(inputErrorOf([&] { (void)weld(raw); }), "vertex 4"));
  raw.positions[4].z() = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(contains(inputErrorOf([&] { (void)weld(raw); }), "finite"));
  raw.positions[4].z() = 1e300;
  EXPECT_TRUE(contains(inputErrorOf([&] { (void)weld(raw); }), "too large"));
  raw = seamSquare();
  raw.triangles[1][2] = 6;
  EXPECT_TRUE(contains(inputErrorOf([&] { (void)weld(raw); }), "uses vertex 6"));
  raw.triangles[1][2] = -1;
  EXPECT_TRUE(contains(inputErrorOf([&] { (void)weld(raw); }), "uses vertex -1"));
  raw.triangles.clear();
  EXPECT_TRUE(contains(inputErrorOf([&] { (void)weld(raw); }), "no faces"));
  raw = seamSquare();
  raw.uvs.pop_back();
  EXPECT_TRUE(contains(inputErrorOf([&] { (void)weld(raw); }), "texture coordinates"));
}

TEST(MeshWeld, refusesAMeshWithoutAnyArea) {
  RawMesh raw = seamSquare();
  for (Vec3& position : raw.positions) {
    position = Vec3(2, 2, 2);
  }
  EXPECT_TRUE(contains(inputErrorOf([&] { (void)weld(raw); }), "area"));
}

TEST(MeshWeld, refusesAMeshThatWouldLoseMostOfItsFaces) {
  RawMesh raw = seamSquare();
  for (int i = 0; i < 3; ++i) {
    raw.triangles.push_back({0, 0, 1});
  }
  EXPECT_TRUE(contains(inputErrorOf([&] { (void)weld(raw); }), "3 of its 5 faces have no area"));
}

TEST(MeshWeld, refusesMeshesThatNoUnitMakesSoLarge) {
  ImportOptions options;
  options.metresPerUnit = 1e15;
  EXPECT_TRUE(contains(inputErrorOf([&] { (void)weldMesh(seamSquare(), "mesh.obj", options); }),
                       "large, and meshes above 1e+06 km are not simulated"));
  options.metresPerUnit = 1e6;
  EXPECT_NO_THROW((void)weldMesh(seamSquare(), "mesh.obj", options));
}

TEST(MeshWeld, refusesClothBelowAMillimetreAndTakesASmallBody) {
  ImportOptions options;
  options.metresPerUnit = 1.6e-6;
  const std::string message = inputErrorOf([&] { (void)weldMesh(seamSquare(), "mesh.obj", options); });
  EXPECT_TRUE(contains(message, "it is 1.6 um large, and the minimum is 1 mm")) << message;
  EXPECT_TRUE(contains(message, "--set unit"));
  options.use = MeshUse::Body;
  EXPECT_NO_THROW((void)weldMesh(seamSquare(), "mesh.obj", options));
}

TEST(MeshWeld, keepsTextureCoordinatesWhereAShortEdgeIsMerged) {
  RawMesh raw = seamSquare();
  raw.positions.emplace_back(1, 1e-5, 0);  // near vertex 1, with different texture coordinates
  raw.uvs.emplace_back(7, 7);
  raw.triangles = {{0, 1, 2}, {1, 6, 2}, {6, 4, 2}};
  ImportOptions options;
  options.weldTolerance = 0.0;
  const ImportedMesh mesh = weldMesh(raw, "mesh.obj", options);
  EXPECT_EQ(mesh.summary.shortEdges, 1);
  ASSERT_EQ(mesh.cloth.triangles.size(), 2U);
  const auto corner = static_cast<std::size_t>(mesh.render.triangles[1][0]);
  EXPECT_EQ(mesh.render.uvs[corner], Vec2(7, 7));
  EXPECT_EQ(mesh.render.particle[corner], mesh.cloth.triangles[1][0]);
}

TEST(MeshWeld, refusesAUnitThatIsNoLength) {
  for (const double unit : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    ImportOptions options;
    options.metresPerUnit = unit;
    EXPECT_TRUE(contains(inputErrorOf([&] { (void)weldMesh(seamSquare(), "mesh.obj", options); }), "unit"));
  }
}

}  // namespace
}  // namespace drape::io
