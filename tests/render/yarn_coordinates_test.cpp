#include "render/yarn_coordinates.hpp"
#include "sim/fabric/rest_shape.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::render {
namespace {

/// A vertical rectangle, 2 m wide and 1 m high, which faces +z.
std::vector<Vec3> rectangle() {
  return {{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {2.0, 1.0, 0.0}, {0.0, 1.0, 0.0}};
}

io::RenderMesh meshWith(std::vector<Vec2> uvs) {
  io::RenderMesh mesh;
  mesh.particle = {0, 1, 2, 3};
  mesh.uvs = std::move(uvs);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// The coordinates for a vertical warp.
std::vector<Vec2> yarnsOf(const io::RenderMesh& mesh, const std::vector<Vec3>& rest) {
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.push_back({mesh.particle[a], mesh.particle[b], mesh.particle[c]});
  }
  return yarnCoordinates(mesh, rest, sim::fabric::warpAlong(Vec3::UnitY(), rest, triangles));
}

void expectNear(const Vec2& actual, const Vec2& expected) {
  EXPECT_LT((actual - expected).norm(), 1e-9) << actual.transpose() << " is not " << expected.transpose();
}

TEST(YarnCoordinates, AreMetresAlongWeftAndVerticalWarp) {
  const auto yarns = yarnsOf(meshWith({{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.25}, {0.0, 0.25}}), rectangle());
  ASSERT_EQ(yarns.size(), 4U);
  expectNear(yarns[1] - yarns[0], {2.0, 0.0});
  expectNear(yarns[3] - yarns[0], {0.0, 1.0});
}

TEST(YarnCoordinates, WarpIsVerticalWhereTheTextureIsTurnedAndStretched) {
  // u runs down, v to the right, each with another scale.
  const auto yarns = yarnsOf(meshWith({{3.0, 0.0}, {3.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}}), rectangle());
  expectNear(yarns[1] - yarns[0], {2.0, 0.0});
  expectNear(yarns[3] - yarns[0], {0.0, 1.0});
}

TEST(YarnCoordinates, FollowTheWarpThatTheSceneGives) {
  const std::vector<Vec3> alongX(2, Vec3::UnitX());
  const auto yarns = yarnCoordinates(meshWith({{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.25}, {0.0, 0.25}}), rectangle(), alongX);
  expectNear(yarns[1] - yarns[0], {0.0, 2.0});
}

TEST(YarnCoordinates, AMirroredTextureGivesTheSameYarns) {
  const auto yarns = yarnsOf(meshWith({{1.0, 0.0}, {0.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}), rectangle());
  expectNear(yarns[1] - yarns[0], {2.0, 0.0});
  expectNear(yarns[3] - yarns[0], {0.0, 1.0});
}

TEST(YarnCoordinates, FrontAndBackOfAPlanarProjectionKeepTheirScale) {
  // A tube that is projected along z: the back is mirrored in the texture. A plain mean would have no width.
  std::vector<Vec3> tube{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.1},  {1.0, 1.0, 0.1},
                         {0.0, 1.0, 0.0}, {1.0, 0.0, -0.1}, {1.0, 1.0, -0.1}};
  io::RenderMesh mesh;
  mesh.particle = {0, 1, 2, 3, 4, 5};
  for (const Vec3& place : tube) {
    mesh.uvs.emplace_back(place.x(), place.y());
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 0, 3}, {4, 3, 5}};
  const auto yarns = yarnsOf(mesh, tube);
  EXPECT_NEAR(std::abs(yarns[1].x() - yarns[0].x()), std::hypot(1.0, 0.1), 1e-6);
}

TEST(YarnCoordinates, EachPieceOfTheTextureHasItsOwnScale) {
  io::RenderMesh mesh = meshWith({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}});
  mesh.particle = {0, 1, 2, 0, 2, 3};  // a seam along the diagonal
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  const auto yarns = yarnsOf(mesh, rectangle());
  expectNear(yarns[1] - yarns[0], {2.0, 0.0});
  expectNear(yarns[4] - yarns[5], {2.0, 0.0});
}

TEST(YarnCoordinates, MissingOrFlatTexturesAreHarmless) {
  EXPECT_TRUE(yarnsOf(meshWith({}), rectangle()).empty());
  for (const Vec2& place : yarnsOf(meshWith(std::vector<Vec2>(4, Vec2(0.3, 0.7))), rectangle())) {
    expectNear(place, {0.0, 0.0});
  }
}

}  // namespace
}  // namespace drape::render
