#include "figure/periodic_curve.hpp"

#include <gtest/gtest.h>

namespace drape::figure {
namespace {

TEST(PeriodicCurve, meetsItsKeysAndRepeats) {
  const PeriodicCurve curve({{0.1, 2.0}, {0.4, -1.0}, {0.7, 3.0}});
  for (const double turn : {-1.0, 0.0, 2.0}) {
    EXPECT_NEAR(curve.at(turn + 0.1), 2.0, 1e-12);
    EXPECT_NEAR(curve.at(turn + 0.4), -1.0, 1e-12);
    EXPECT_NEAR(curve.at(turn + 0.7), 3.0, 1e-12);
  }
  EXPECT_NEAR(curve.at(0.05), curve.at(1.05), 1e-12);
}

TEST(PeriodicCurve, hasAContinuousSlope) {
  const PeriodicCurve curve({{0.0, 2.0}, {0.1, -1.0}, {0.7, 3.0}, {0.9, 3.0}});
  constexpr double step = 1e-5;
  for (const double key : {0.0, 0.1, 0.7, 0.9}) {
    const double before = (curve.at(key + 1.0) - curve.at(key + 1.0 - step)) / step;
    const double after = (curve.at(key + step) - curve.at(key)) / step;
    EXPECT_NEAR(before, after, 0.05) << key;
  }
}

TEST(SmoothStep, isLevelAtBothEnds) {
  EXPECT_EQ(smoothStep(-1.0), 0.0);
  EXPECT_EQ(smoothStep(2.0), 1.0);
  EXPECT_EQ(smoothStep(0.5), 0.5);
  EXPECT_LT(smoothStep(1e-4), 1e-7);
}

}  // namespace
}  // namespace drape::figure
