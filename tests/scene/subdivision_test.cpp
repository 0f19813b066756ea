#include "scene/subdivision.hpp"

#include "mesh_text_test.hpp"
#include "scene/boundary_loops.hpp"
#include "scene/grid_mesh.hpp"
#include "sim/model/cloth_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace drape::scene {
namespace {

/// A square of two triangles whose texture coordinates have a seam along the diagonal.
constexpr const char* squareWithSeam =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 5 5\nvt 6 6\nvt 5 6\n"
    "f 1/1 2/2 3/3\nf 1/4 3/5 4/6\n";

class Subdivision : public MeshTextTest {
 protected:
  Subdivision() : MeshTextTest({"pins=none"}) {}
};

double areaOf(const Scene& scene) {
  double sum = 0.0;
  for (const auto& [a, b, c] : scene.model->triangles) {
    const std::vector<Vec3>& rest = scene.model->restPositions;
    sum += 0.5 * (rest[b] - rest[a]).cross(rest[c] - rest[a]).norm();
  }
  return sum;
}

std::vector<int> pinsOf(const Scene& scene) {
  std::vector<int> pins;
  for (int v = 0; v < scene.model->vertexCount(); ++v) {
    if (scene.model->pinned[v]) {
      pins.push_back(v);
    }
  }
  return pins;
}

TEST_F(Subdivision, makesFourTrianglesOfEachAndKeepsTheVerticesAndTheShape) {
  const auto coarse = build(squareWithSeam);
  const auto fine = build(squareWithSeam, {"subdivide=2"});
  EXPECT_EQ(fine->model->triangles.size(), 32U);
  EXPECT_EQ(fine->model->vertexCount(), 25);
  EXPECT_NEAR(areaOf(*fine), 1.0, 1e-12);
  for (int v = 0; v < coarse->model->vertexCount(); ++v) {
    EXPECT_EQ(fine->model->restPositions[v], coarse->model->restPositions[v]);
    EXPECT_EQ(fine->start.positions[v], coarse->start.positions[v]);
  }
  EXPECT_EQ(fine->summary.triangles, 32);
  EXPECT_EQ(fine->summary.vertices, 25);
  EXPECT_EQ(fine->summary.springs, static_cast<int>(fine->model->springs.size()));
}

TEST_F(Subdivision, keepsTheDirectionOfTheTriangles) {
  const auto fine = build(squareWithSeam, {"subdivide=1"});
  for (const auto& [a, b, c] : fine->model->triangles) {
    const std::vector<Vec3>& rest = fine->model->restPositions;
    EXPECT_NEAR((rest[b] - rest[a]).cross(rest[c] - rest[a]).z(), 0.25, 1e-12);
  }
}

TEST_F(Subdivision, keepsASeamOfTheTextureAndJoinsTheClothThere) {
  const auto fine = build(squareWithSeam, {"subdivide=1"});
  const io::RenderMesh& render = fine->renderMesh;
  ASSERT_EQ(render.triangles.size(), fine->model->triangles.size());
  for (std::size_t t = 0; t < render.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(render.particle[render.triangles[t][k]], fine->model->triangles[t][k]);
    }
  }
  const auto middle = std::ranges::find(fine->model->restPositions, Vec3(0.5, 0.5, 0.0));
  ASSERT_NE(middle, fine->model->restPositions.end());
  std::vector<double> us;
  for (std::size_t v = 0; v < render.particle.size(); ++v) {
    if (render.particle[v] == static_cast<int>(middle - fine->model->restPositions.begin())) {
      us.push_back(render.uvs[v].x());
    }
  }
  std::ranges::sort(us);
  EXPECT_EQ(us, (std::vector<double>{0.5, 5.5})) << "one vertex of the cloth, two of the texture";
}

TEST_F(Subdivision, pinsTheMiddlesOfEdgesBetweenPinsOnly) {
  // The upper edge is pinned.
  const auto fine = build(squareWithSeam, {"pins=top", "subdivide=2"});
  std::vector<double> heights;
  std::vector<double> xs;
  for (const int v : pinsOf(*fine)) {
    heights.push_back(fine->model->restPositions[v].y());
    xs.push_back(fine->model->restPositions[v].x());
  }
  std::ranges::sort(xs);
  EXPECT_EQ(xs, (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
  EXPECT_TRUE(std::ranges::all_of(heights, [](double y) { return y == 1.0; }));
}

TEST_F(Subdivision, givesTheExportAllTriangles) {
  const auto fine = build(squareWithSeam, {"subdivide=1"});
  const io::FileMesh& file = *fine->cloths.front().file;
  EXPECT_EQ(file.faceEnds.size(), 8U);
  EXPECT_EQ(file.particle.size(), fine->renderMesh.particle.size());
  EXPECT_EQ(*std::ranges::max_element(file.particle), fine->model->vertexCount() - 1);
}

TEST_F(Subdivision, isRefusedWhereTheMeshWouldGetTooLarge) {
  io::ImportedMesh grid = makeGrid({257, 257, 1.0, 1.0}, GridSource::Plane::Vertical);
  try {
    static_cast<void>(subdivided(std::move(grid), 3));
    FAIL() << "131072 triangles became 8388608";
  } catch (const messages::InputError& error) {
    EXPECT_STREQ(error.what(),
                 "grid: subdivide = 3 would divide its 131072 triangles into 8388608 (4000000 at most); choose a "
                 "smaller number");
  }
}

/// The middles of a grid with one diagonal a cell make the grid of the next resolution.
TEST(SubdividedGrid, isTheGridOfTwiceTheResolution) {
  const io::ImportedMesh once = subdivided(makeGrid({3, 3, 1.0, 1.0}, GridSource::Plane::Vertical), 1).mesh;
  const io::ImportedMesh finer = makeGrid({5, 5, 1.0, 1.0}, GridSource::Plane::Vertical);
  const auto trianglesOf = [](const io::ImportedMesh& mesh) {
    std::vector<std::array<double, 2>> centres;
    for (const auto& [a, b, c] : mesh.cloth.triangles) {
      const Vec3 sum = mesh.cloth.positions[a] + mesh.cloth.positions[b] + mesh.cloth.positions[c];
      centres.push_back({sum.x(), sum.y()});
    }
    std::ranges::sort(centres);
    return centres;
  };
  EXPECT_EQ(trianglesOf(once), trianglesOf(finer));
}

}  // namespace
}  // namespace drape::scene
