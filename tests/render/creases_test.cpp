#include "render/creases.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace drape::render {
namespace {

/// A strip of three squares, folded along its two inner edges by the given angle [rad].
CreasedMesh foldedStrip(double angle) {
  CreasedMesh mesh;
  Vec3 position(0.0, 0.0, 0.0);
  double direction = 0.0;
  for (int row = 0; row < 4; ++row) {
    mesh.positions.push_back(position);
    mesh.positions.emplace_back(position + Vec3(0.0, 0.0, 1.0));
    position += Vec3(std::cos(direction), std::sin(direction), 0.0);
    direction += angle;
  }
  for (int row = 0; row < 3; ++row) {
    const int a = 2 * row;
    mesh.triangles.push_back({a, a + 1, a + 3});
    mesh.triangles.push_back({a, a + 3, a + 2});
  }
  return mesh;
}

TEST(Creases, RoundPartsKeepCommonVertices) {
  const CreasedMesh strip = foldedStrip(0.3);
  const CreasedMesh split = splitAtCreases(strip.positions, strip.triangles, 0.5);
  EXPECT_EQ(split.positions.size(), strip.positions.size());
  EXPECT_EQ(split.triangles.size(), strip.triangles.size());
}

TEST(Creases, SharpEdgesAreSplit) {
  const CreasedMesh strip = foldedStrip(std::numbers::pi / 2.0);
  const CreasedMesh split = splitAtCreases(strip.positions, strip.triangles, 0.5);
  EXPECT_EQ(split.positions.size(), 12U);
  for (std::size_t t = 0; t < strip.triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      EXPECT_EQ(split.positions[static_cast<std::size_t>(split.triangles[t][corner])],
                strip.positions[static_cast<std::size_t>(strip.triangles[t][corner])]);
    }
  }
}

TEST(Creases, NothingGivesNothing) {
  EXPECT_TRUE(splitAtCreases({}, {}, 0.5).triangles.empty());
}

}  // namespace
}  // namespace drape::render
