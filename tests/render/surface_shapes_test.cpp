#include "render/surface_shapes.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::render {
namespace {

/// A square patch of n by n vertices around the origin whose height is a function of x and y.
template <typename Height>
void makePatch(int n, double spacing, Height height, std::vector<Vec3>& positions, std::vector<Triangle>& triangles) {
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const double x = (column - n / 2) * spacing;
      const double y = (row - n / 2) * spacing;
      positions.emplace_back(x, y, height(x, y));
    }
  }
  for (int row = 0; row + 1 < n; ++row) {
    for (int column = 0; column + 1 < n; ++column) {
      const int a = row * n + column;
      triangles.push_back({a, a + 1, a + n + 1});
      triangles.push_back({a, a + n + 1, a + n});
    }
  }
}

TEST(SurfaceShapes, FlatSheetHasOneNormalAndNoCurvature) {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  makePatch(
      5, 0.1, [](double, double) { return 0.0; }, positions, triangles);
  SurfaceShapes shapes;
  shapes.compute(positions, triangles);
  ASSERT_EQ(shapes.values().size(), 25U);
  for (const SurfaceShape& shape : shapes.values()) {
    EXPECT_LT((shape.normal - Eigen::Vector3f(0.0F, 0.0F, 1.0F)).norm(), 1e-6F);
    EXPECT_NEAR(shape.curvature, 0.0F, 1e-4F);
  }
}

TEST(SurfaceShapes, BowlHasItsMeanCurvatureWithASign) {
  for (const double curvature : {4.0, -4.0}) {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
    makePatch(
        9, 0.005, [curvature](double x, double y) { return 0.5 * curvature * (x * x + y * y); }, positions, triangles);
    SurfaceShapes shapes;
    shapes.compute(positions, triangles);
    EXPECT_NEAR(shapes.values()[40].curvature, curvature, 0.02 * 4.0);  // the middle
  }
}

TEST(SurfaceShapes, NormalsAreWeightedByArea) {
  // Vertex 0 belongs to a large triangle that faces z and to a small one that faces x.
  const std::vector<Vec3> positions{{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 3, 2}};
  SurfaceShapes shapes;
  shapes.compute(positions, triangles);
  const Eigen::Vector3f normal = shapes.values()[0].normal;
  EXPECT_NEAR(std::abs(normal.x()) / normal.z(), 1.0F / 3.0F, 1e-6F);
}

TEST(SurfaceShapes, VertexWithoutAreaPointsUp) {
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}};
  const std::vector<Triangle> triangles{{0, 1, 2}};
  SurfaceShapes shapes;
  shapes.compute(positions, triangles);
  for (const SurfaceShape& shape : shapes.values()) {
    EXPECT_EQ(shape.normal, Eigen::Vector3f(0.0F, 1.0F, 0.0F));
    EXPECT_TRUE(std::isfinite(shape.curvature));
  }
}

}  // namespace
}  // namespace drape::render
