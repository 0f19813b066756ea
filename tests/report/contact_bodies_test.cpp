#include "report/hardcases/contact_bodies.hpp"

#include "sim/model/enclosed_volume.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace drape::report::hardcases {
namespace {

double volumeOf(const sim::contact::MeshShape& shape) {
  return sim::enclosedVolume(shape.positions, shape.triangles);
}

/// The number of sides of triangles without another side in the opposite direction.
int openSides(const sim::contact::MeshShape& shape) {
  std::map<std::pair<int, int>, int> sides;
  for (const Triangle& t : shape.triangles) {
    for (int k = 0; k < 3; ++k) {
      ++sides[{t[k], t[(k + 1) % 3]}];
    }
  }
  int open = 0;
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    open += sides.contains({side.second, side.first}) ? 0 : 1;
  }
  return open;
}

TEST(ContactBodies, areClosedAndFaceOutwards) {
  constexpr double pi = std::numbers::pi;
  const auto torus = torusShape(0.2, 0.05);
  const auto spike = spikeShape(0.1, 0.6);
  const auto blade = bladeShape(0.5, 0.4, 0.04);
  for (const auto& shape : {torus, spike, blade}) {
    EXPECT_EQ(openSides(*shape), 0);
  }
  EXPECT_NEAR(volumeOf(*torus), 2.0 * pi * pi * 0.2 * 0.05 * 0.05, 0.05 * volumeOf(*torus));
  EXPECT_NEAR(volumeOf(*spike), pi * 0.1 * 0.1 * 0.6 / 3.0, 0.02 * volumeOf(*spike));
  EXPECT_NEAR(volumeOf(*blade), 0.5 * 0.5 * 0.4 * 0.04, 1e-12);
}

TEST(ContactBodies, includeASphereThatLacksOneTriangleAndShrinks) {
  const auto sphere = hollowSphereShape({0.4, 0.2}, 0.1);
  EXPECT_EQ(openSides(*sphere), 3);
  ASSERT_EQ(sphere->frames.size(), 2U);
  EXPECT_EQ(sphere->positions, sphere->frames.front());
  for (const Vec3& position : sphere->frames.back()) {
    EXPECT_NEAR(position.norm(), 0.2, 1e-12);
  }
}

TEST(ContactBodies, appendAMeshAsASeparatePiece) {
  sim::ClothMesh mesh = revolved({{0.1, 0.2}, {0.1, 0.0}}, 6, false);
  const sim::ClothMesh one = mesh;
  append(mesh, one);
  EXPECT_EQ(mesh.positions.size(), 24U);
  EXPECT_EQ(mesh.triangles.size(), 24U);
  EXPECT_EQ(mesh.triangles[12],
            (Triangle{12 + one.triangles[0][0], 12 + one.triangles[0][1], 12 + one.triangles[0][2]}));
}

}  // namespace
}  // namespace drape::report::hardcases
