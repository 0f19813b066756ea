#include "ui/solver_facts.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace drape::ui {
namespace {

TEST(DescribeStepLimit, IsAFractionThatIsNeverTooLong) {
  EXPECT_EQ(describeStepLimit(1.0 / 240.0), "1/240 s");
  EXPECT_EQ(describeStepLimit(1.0 / 240.3), "1/241 s");
  EXPECT_EQ(describeStepLimit(1.0 / 7.0), "1/7 s");
  EXPECT_EQ(describeStepLimit(0.75), "0.750 s");
}

TEST(DescribeStepLimit, SaysWhenThereIsNone) {
  EXPECT_EQ(describeStepLimit(std::numeric_limits<double>::infinity()), "none");
}

}  // namespace
}  // namespace drape::ui
