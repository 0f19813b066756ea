#include "render/picking.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace drape::render {
namespace {

const std::vector<Vec3> positions{{0.0, 0.0, 0.0},  {1.0, 0.0, 0.0},  {0.0, 1.0, 0.0},
                                  {0.0, 0.0, -1.0}, {1.0, 0.0, -1.0}, {0.0, 1.0, -1.0}};
const std::vector<Triangle> farAndNear{{3, 4, 5}, {0, 1, 2}};

TEST(Picking, HitsTheNearestOfTwo) {
  const auto hit = pick({{0.2, 0.3, 2.0}, {0.0, 0.0, -1.0}}, positions, farAndNear);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->triangle, 1);
  EXPECT_NEAR(hit->distance, 2.0, 1e-12);
  EXPECT_LT((hit->point - Vec3(0.2, 0.3, 0.0)).norm(), 1e-12);
}

TEST(Picking, HitsFromBehind) {
  const auto hit = pick({{0.2, 0.3, -3.0}, {0.0, 0.0, 1.0}}, positions, farAndNear);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->triangle, 0);
  EXPECT_NEAR(hit->distance, 2.0, 1e-12);
}

TEST(Picking, BarycentricsReproduceThePoint) {
  const Vec3 direction = Vec3(0.1, -0.05, -1.0).normalized();
  const auto hit = pick({{0.1, 0.4, 1.5}, direction}, positions, farAndNear);
  ASSERT_TRUE(hit);
  Vec3 point = Vec3::Zero();
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const auto vertex = static_cast<std::size_t>(farAndNear[static_cast<std::size_t>(hit->triangle)][corner]);
    point += hit->barycentric[static_cast<int>(corner)] * positions[vertex];
  }
  EXPECT_NEAR(hit->barycentric.sum(), 1.0, 1e-12);
  EXPECT_LT((point - hit->point).norm(), 1e-12);
}

TEST(Picking, MissesBesideBehindAndAlong) {
  EXPECT_FALSE(pick({{0.8, 0.8, 2.0}, {0.0, 0.0, -1.0}}, positions, farAndNear));
  EXPECT_FALSE(pick({{0.2, 0.2, 2.0}, {0.0, 0.0, 1.0}}, positions, farAndNear));
  EXPECT_FALSE(pick({{-1.0, 0.2, 0.0}, {1.0, 0.0, 0.0}}, positions, farAndNear));
  EXPECT_FALSE(pick({{0.2, 0.2, 2.0}, {0.0, 0.0, -1.0}}, positions, {}));
}

TEST(Picking, IgnoresTrianglesWithoutAreaAndBrokenPositions) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vec3> broken{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, 0.0, 0.0}, {nan, nan, nan}};
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 1, 3}, {1, 1, 1}};
  EXPECT_FALSE(pick({{0.5, 0.0, 1.0}, {0.0, 0.0, -1.0}}, broken, triangles));
}

TEST(Picking, HitsVerySmallTriangles) {
  const std::vector<Vec3> small{{0.0, 0.0, 0.0}, {1e-5, 0.0, 0.0}, {0.0, 1e-5, 0.0}};
  const std::vector<Triangle> triangles{{0, 1, 2}};
  EXPECT_TRUE(pick({{2e-6, 2e-6, 1.0}, {0.0, 0.0, -1.0}}, small, triangles));
}

}  // namespace
}  // namespace drape::render
