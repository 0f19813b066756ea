#include "sim/motion/unfolding.hpp"

#include "sim/forces/diagnostics.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

namespace drape::sim {
namespace {

constexpr double thin = 1e-9;

TEST(Unfolding, countsThePointsDimensions) {
  const Vec3 a(1.0, 2.0, 3.0);
  const Vec3 b(2.0, 2.0, 3.0);
  EXPECT_EQ(dimensionsOf(std::vector<Vec3>{}, thin), 0);
  EXPECT_EQ(dimensionsOf(std::vector<Vec3>{a, a}, thin), 0);
  EXPECT_EQ(dimensionsOf(std::vector<Vec3>{a, b, 0.3 * a + 0.7 * b}, thin), 1);
  EXPECT_EQ(dimensionsOf(std::vector<Vec3>{a, b, Vec3(1.0, 1.0, 4.0)}, thin), 2);
  EXPECT_EQ(dimensionsOf(std::vector<Vec3>{a, b, Vec3(1.0, 1.0, 4.0), Vec3(0.0, 0.0, 0.0)}, thin), 3);
  EXPECT_EQ(dimensionsOf(std::vector<Vec3>{a, a + Vec3(0.0, 1e-10, 0.0)}, thin), 0);
}

TEST(Unfolding, leavesAStartAloneThatFillsAsMuchAsTheRestShape) {
  const auto model = testing::pinnedSheet(5);
  ClothState state = stateAtRest(model->restPositions);
  const auto before = stateHash(state);
  EXPECT_FALSE(makeUnfoldable(*model, state));
  EXPECT_EQ(stateHash(state), before);
}

TEST(Unfolding, givesVerticesThatFallTogetherDirectionsAndMovesNoPin) {
  const auto model = testing::pinnedSheet(5);
  ClothState state = stateAtRest(std::vector<Vec3>(25, Vec3(1.0, 2.0, 3.0)));
  EXPECT_TRUE(makeUnfoldable(*model, state));
  EXPECT_EQ(state.positions[0], Vec3(1.0, 2.0, 3.0));
  EXPECT_GT((state.positions[7] - state.positions[6]).norm(), 1e-7);
  EXPECT_LT((state.positions[24] - Vec3(1.0, 2.0, 3.0)).norm(), 1e-6);
  EXPECT_FALSE(makeUnfoldable(*model, state)) << "once is enough";
}

}  // namespace
}  // namespace drape::sim
