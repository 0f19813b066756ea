#include "sim/measures/measures.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::sim {
namespace {

/// Positions of the method and of the reference at two checkpoints; both start at the same positions.
struct Motion {
  std::vector<Vec3> start;
  std::vector<Vec3> own;
  std::vector<Vec3> reference;

  [[nodiscard]] CheckpointPair pair() const { return {start, own, start, reference}; }
};

/// Every free vertex moves by `own`, and by `reference` in the reference; pinned ones stay.
Motion translation(const ClothModel& model, const Vec3& own, const Vec3& reference) {
  Motion motion{model.restPositions, model.restPositions, model.restPositions};
  for (std::size_t i = 0; i < motion.start.size(); ++i) {
    if (!model.pinned[i]) {
      motion.own[i] += own;
      motion.reference[i] += reference;
    }
  }
  return motion;
}

DisplacementError errorOf(const ClothModel& model, const Motion& motion) {
  return displacementError(model, motion.pair(), diagonalOf(model));
}

TEST(Distance, hasTheClosedFormForThreeAndFour) {
  const std::vector<Vec3> a(2, Vec3::Zero());
  const std::vector<Vec3> b{Vec3(3.0, 0.0, 0.0), Vec3(0.0, 0.0, -4.0)};
  EXPECT_DOUBLE_EQ(meanDistance(a, b), 3.5);
  EXPECT_DOUBLE_EQ(rmsDistance(a, b), std::sqrt(12.5));
  EXPECT_EQ(meanDistance({}, {}), 0.0);
  EXPECT_EQ(rmsDistance({}, {}), 0.0);
}

TEST(Diagonal, isThatOfTheRestShape) {
  EXPECT_DOUBLE_EQ(diagonalOf(*testing::pinnedSheet(4)), std::sqrt(2.0));
}

TEST(DisplacementError, isNoneForTheReferenceItself) {
  const auto model = testing::pinnedSheet(4);
  const Vec3 step(0.1, -0.2, 0.05);
  const DisplacementError error = errorOf(*model, translation(*model, step, step));
  EXPECT_NEAR(error.eps, 0.0, 1e-28);
  EXPECT_NEAR(error.squaredCosine, 1.0, 1e-14);
  EXPECT_EQ(error.vertices, 14);
}

TEST(DisplacementError, ofATranslationTooFarByAFifthIsAFifthSquaredAndHasTheRightDirection) {
  const auto model = testing::pinnedSheet(4);
  const Vec3 step(0.1, -0.2, 0.05);
  const DisplacementError error = errorOf(*model, translation(*model, 1.2 * step, step));
  EXPECT_NEAR(error.eps, 0.04, 1e-13);
  EXPECT_NEAR(error.squaredCosine, 1.0, 1e-14);
}

TEST(DisplacementError, ofAMotionAtRightAnglesHasNoCosine) {
  const auto model = testing::pinnedSheet(4);
  const DisplacementError error = errorOf(*model, translation(*model, Vec3(0.3, 0.0, 0.0), Vec3(0.0, 0.1, 0.0)));
  EXPECT_NEAR(error.eps, 10.0, 1e-12);
  EXPECT_EQ(error.squaredCosine, 0.0);
}

TEST(DisplacementError, ofAMotionAtAnAngleHasItsSquaredCosine) {
  const auto model = testing::pinnedSheet(4);
  const DisplacementError error = errorOf(*model, translation(*model, Vec3(-0.1, -0.1, 0.0), Vec3(0.0, 0.2, 0.0)));
  EXPECT_NEAR(error.squaredCosine, 0.5, 1e-14);
}

TEST(DisplacementError, ofAFrozenClothIsOneWithoutCosine) {
  const auto model = testing::pinnedSheet(4);
  const DisplacementError error = errorOf(*model, translation(*model, Vec3::Zero(), Vec3(0.0, -0.1, 0.0)));
  EXPECT_DOUBLE_EQ(error.eps, 1.0);
  EXPECT_EQ(error.squaredCosine, 0.0);
}

TEST(DisplacementError, leavesStillVerticesOutButReportsTheirMotion) {
  const auto model = testing::pinnedSheet(4);
  Motion motion = translation(*model, Vec3(0.0, -0.11, 0.0), Vec3(0.0, -0.1, 0.0));
  motion.reference[5] = motion.start[5] + Vec3(0.0, 1e-7, 0.0);
  motion.own[5] = motion.start[5] + Vec3(0.0, 0.0, 0.25);
  const DisplacementError error = errorOf(*model, motion);
  EXPECT_EQ(error.vertices, 13);
  EXPECT_EQ(error.stillVertices, 1);
  EXPECT_DOUBLE_EQ(error.stillMotion, 0.25);
  EXPECT_NEAR(error.eps, 0.01, 1e-13);
}

TEST(DisplacementError, isNotANumberWhereNothingIsLeftToJudge) {
  const auto model = testing::pinnedSheet(4);
  const DisplacementError error = errorOf(*model, translation(*model, Vec3(0.0, 0.3, 0.0), Vec3::Zero()));
  EXPECT_TRUE(std::isnan(error.eps));
  EXPECT_TRUE(std::isnan(error.squaredCosine));
  EXPECT_EQ(error.stillVertices, 14);
  EXPECT_DOUBLE_EQ(error.stillMotion, 0.3);
}

TEST(MotionKept, isTheRatioOfTheMotionsAndZeroWhenFrozen) {
  const auto model = testing::pinnedSheet(4);
  const Vec3 step(0.0, -0.2, 0.1);
  EXPECT_DOUBLE_EQ(motionKept(*model, translation(*model, step, step).pair()), 1.0);
  EXPECT_NEAR(motionKept(*model, translation(*model, -0.3 * step, step).pair()), 0.3, 1e-14);
  EXPECT_EQ(motionKept(*model, translation(*model, Vec3::Zero(), step).pair()), 0.0);
}

TEST(MotionKept, weighsTheVerticesByTheirMass) {
  // Area lumping gives the corners of a sheet of 2 x 2 a third and a sixth of its mass by turns.
  const auto model = buildClothModel(testing::sheet(2), 0.6, MassLumping::Area, {});
  Motion motion = translation(*model, Vec3::Zero(), Vec3(0.0, 1.0, 0.0));
  motion.own[0] += Vec3(0.0, 0.0, 1.0);
  EXPECT_NEAR(motionKept(*model, motion.pair()), std::sqrt(model->vertexMass[0] / 0.6), 1e-14);
  EXPECT_NEAR(model->vertexMass[0], 0.2, 1e-14);
}

TEST(MotionKept, overARunIsTheRatioOfTheSums) {
  const auto model = testing::pinnedSheet(4);
  MotionKept kept;
  kept.add(*model, translation(*model, Vec3(0.0, 0.3, 0.0), Vec3(0.0, 0.4, 0.0)).pair());
  kept.add(*model, translation(*model, Vec3(0.4, 0.0, 0.0), Vec3(0.3, 0.0, 0.0)).pair());
  EXPECT_NEAR(kept.value(), 1.0, 1e-14);
}

TEST(MotionKept, isInfiniteWhereOnlyTheMethodMovesAndOneWhereNothingDoes) {
  const auto model = testing::pinnedSheet(4);
  EXPECT_TRUE(std::isinf(motionKept(*model, translation(*model, Vec3(0.0, 1.0, 0.0), Vec3::Zero()).pair())));
  EXPECT_EQ(motionKept(*model, translation(*model, Vec3::Zero(), Vec3::Zero()).pair()), 1.0);
}

}  // namespace
}  // namespace drape::sim
