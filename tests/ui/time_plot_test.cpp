#include "ui/time_plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace drape::ui {
namespace {

TEST(PlotScale, CoversTheRangeAndZeroInAFewRoundSteps) {
  for (const double low : {-1e30, -731.0, -0.6, -1e-9, 0.0, 0.2, 5.0}) {
    for (const double high : {0.0, 1e-9, 0.13, 0.9, 17.0, 5e29}) {
      if (high < low) {
        continue;
      }
      const PlotScale scale = plotScale(low, high, 4);
      EXPECT_LE(scale.low, std::min(low, 0.0));
      EXPECT_GE(scale.high, high);
      EXPECT_GT(scale.high, scale.low);
      EXPECT_LE((scale.high - scale.low) / scale.step, 4.0 + 1e-9) << low << " to " << high;
      const double leading = scale.step / std::pow(10.0, std::floor(std::log10(scale.step) + 1e-9));
      EXPECT_TRUE(std::abs(leading - 1.0) < 1e-6 || std::abs(leading - 2.0) < 1e-6 || std::abs(leading - 5.0) < 1e-6)
          << scale.step;
    }
  }
}

TEST(PlotScale, DoesNotWasteHalfOfTheRoom) {
  const PlotScale scale = plotScale(0.0, 0.21, 4);
  EXPECT_LE(scale.high, 0.4 + 1e-12);
}

TEST(PlotScale, HasSomethingToShowForNothing) {
  EXPECT_EQ(plotScale(0.0, 0.0, 4).high, 1.0);
  EXPECT_EQ(plotScale(0.0, std::numeric_limits<double>::infinity(), 4).high, 1.0);
}

}  // namespace
}  // namespace drape::ui
