#include "report/timing.hpp"

#include "small_grid.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::report {
namespace {

TEST(Quantiles, areOfTheNearestRank) {
  EXPECT_EQ(medianOf({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(medianOf({4.0, 1.0, 3.0, 2.0}), 2.0);
  std::vector<double> hundred;
  for (int i = 1; i <= 100; ++i) {
    hundred.push_back(i);
  }
  EXPECT_EQ(quantileOf(hundred, 0.99), 99.0);
  EXPECT_TRUE(std::isnan(medianOf({})));
}

TEST(FittedExponent, isThatOfAPowerLaw) {
  EXPECT_NEAR(fittedExponent({1.0, 2.0, 8.0}, {3.0, 3.0 * std::pow(2.0, 1.5), 3.0 * std::pow(8.0, 1.5)}), 1.5, 1e-12);
  EXPECT_TRUE(std::isnan(fittedExponent({1.0}, {1.0})));
  EXPECT_TRUE(std::isnan(fittedExponent({2.0, 2.0}, {1.0, 3.0})));
}

TEST(TimeSteps, takesAsManyStepsAsItsBudgetAllows) {
  const auto scene = testing::smallGrid();
  int asked = 0;
  const auto count = [&asked] { ++asked; };
  EXPECT_EQ(
      timeSteps(*scene, scene->settings, {.seconds = 0.0, .minSteps = 4, .maxSteps = 9}, count).stepSeconds.size(), 4U);
  EXPECT_EQ(asked, 5);  // and one before, for the set-up
  EXPECT_EQ(
      timeSteps(*scene, scene->settings, {.seconds = 1e9, .minSteps = 4, .maxSteps = 9}, count).stepSeconds.size(), 9U);
}

TEST(TimeSteps, countsTheMemoryOfASolverWithADenseMatrix) {
  // The inverse of the whole matrix: one number per pair of vertices.
  const auto scene = testing::smallGrid({"solver=desbrun", "grid.resolution=21"});
  const StepTiming timing = timeSteps(*scene, scene->settings, {.seconds = 0.0, .minSteps = 1, .maxSteps = 1}, [] {});
  const double pairs = 441.0 * 441.0;
  if (!std::isnan(timing.memoryBytes)) {
    EXPECT_GT(timing.memoryBytes, 8.0 * pairs);
    EXPECT_LT(timing.memoryBytes, 32.0 * pairs);
  }
}

TEST(TimeSteps, continuesAfterTheClothBlewUpAndReportsIt) {
  const auto scene = testing::smallGrid({"solver=verlet", "stiffness=1e7"});
  const StepTiming timing =
      timeSteps(*scene, scene->settings, {.seconds = 0.0, .minSteps = 400, .maxSteps = 400}, [] {});
  EXPECT_FALSE(timing.finite);
  EXPECT_EQ(timing.stepSeconds.size(), 400U);
}

}  // namespace
}  // namespace drape::report
