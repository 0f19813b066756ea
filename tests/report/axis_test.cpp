#include "report/axis.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace drape::report {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<std::string> labelsOf(const Axis& axis) {
  std::vector<std::string> labels;
  for (const Tick& tick : axis.ticks()) {
    if (!tick.label.empty()) {
      labels.push_back(tick.label);
    }
  }
  return labels;
}

TEST(LogarithmicAxis, hasItsLabelsAtTheDecadesThatHoldTheValues) {
  const Axis axis(Scale::Logarithmic, {0.03, 40.0, 7.0});
  EXPECT_EQ(labelsOf(axis), (std::vector<std::string>{"0.01", "0.1", "1", "10", "100"}));
  EXPECT_NEAR(axis.share(0.01), 0.0, 1e-12);
  EXPECT_NEAR(axis.share(1.0), 0.5, 1e-12);
  EXPECT_NEAR(axis.share(100.0), 1.0, 1e-12);
}

TEST(LogarithmicAxis, endsAtAValueThatIsADecade) {
  EXPECT_EQ(labelsOf(Axis(Scale::Logarithmic, {1e-6, 1e-4})),
            (std::vector<std::string>{"10\u207b\u2076", "10\u207b\u2075", "10\u207b\u2074"}));
  EXPECT_EQ(labelsOf(Axis(Scale::Logarithmic, {10.0})), (std::vector<std::string>{"10", "100"}));
}

TEST(LogarithmicAxis, leavesLabelsOutWhenThereAreManyDecades) {
  const auto labels = labelsOf(Axis(Scale::Logarithmic, {1e-15, 1e15}));
  EXPECT_GE(labels.size(), 5U);
  EXPECT_LE(labels.size(), 9U);
}

TEST(LogarithmicAxis, takesOnlyPositiveValues) {
  const Axis axis(Scale::Logarithmic, {0.0, -1.0, undefined, infinite, 5.0});
  EXPECT_FALSE(axis.takes(0.0));
  EXPECT_FALSE(axis.takes(undefined));
  EXPECT_FALSE(axis.takes(infinite));
  EXPECT_EQ(labelsOf(axis), (std::vector<std::string>{"1", "10"}));
}

TEST(LinearAxis, hasRoundTicksAroundTheValues) {
  const Axis axis(Scale::Linear, {0.0, 0.93});
  EXPECT_EQ(labelsOf(axis), (std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
  EXPECT_NEAR(axis.share(0.5), 0.5, 1e-12);
}

TEST(Axis, hasTicksWithinItsRangeForAllValues) {
  for (const Scale scale : {Scale::Linear, Scale::Logarithmic}) {
    for (const auto& values :
         std::vector<std::vector<double>>{{}, {undefined}, {3.0}, {0.0}, {-2.0, 1e9}, {1e-300, 1e300}}) {
      const Axis axis(scale, values);
      EXPECT_GE(labelsOf(axis).size(), 2U);
      for (const Tick& tick : axis.ticks()) {
        EXPECT_GE(axis.share(tick.value), -1e-9);
        EXPECT_LE(axis.share(tick.value), 1.0 + 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace drape::report
