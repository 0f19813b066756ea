#include "render/surface_coordinates.hpp"

#include <gtest/gtest.h>

namespace drape::render {
namespace {

/// A rectangle of two triangles whose texture fills the given part of the unit square.
io::RenderMesh rectangleMesh(double u, double v) {
  io::RenderMesh mesh;
  mesh.particle = {0, 1, 2, 3};
  mesh.uvs = {{0.0, 0.0}, {u, 0.0}, {u, v}, {0.0, v}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

std::vector<Vec3> rectangle(double width, double height) {
  return {{0.0, 0.0, 0.0}, {width, 0.0, 0.0}, {width, height, 0.0}, {0.0, height, 0.0}};
}

TEST(SurfaceCoordinates, AreMetresOfCloth) {
  const SurfaceCoordinates result = surfaceCoordinates(rectangleMesh(0.5, 0.25), rectangle(2.0, 1.0));
  ASSERT_EQ(result.metres.size(), 4U);
  EXPECT_NEAR(result.metres[2].x(), 2.0, 1e-12);
  EXPECT_NEAR(result.metres[2].y(), 1.0, 1e-12);
}

TEST(SurfaceCoordinates, SquareMetreGetsTenChecks) {
  EXPECT_NEAR(surfaceCoordinates(rectangleMesh(1.0, 1.0), rectangle(1.0, 1.0)).checkSize, 0.1, 1e-12);
  EXPECT_NEAR(surfaceCoordinates(rectangleMesh(1.0, 1.0), rectangle(0.1, 0.1)).checkSize, 0.01, 1e-12);
}

TEST(SurfaceCoordinates, MissingOrFlatTexturesGiveNone) {
  io::RenderMesh without = rectangleMesh(1.0, 1.0);
  without.uvs.clear();
  EXPECT_TRUE(surfaceCoordinates(without, rectangle(1.0, 1.0)).metres.empty());
  EXPECT_TRUE(surfaceCoordinates(rectangleMesh(0.0, 1.0), rectangle(1.0, 1.0)).metres.empty());
}

}  // namespace
}  // namespace drape::render
