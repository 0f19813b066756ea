#include "sim/model/quantile.hpp"

#include <gtest/gtest.h>

namespace drape::sim {
namespace {

TEST(QuantileExceededBy, isExceededByAtMostOneInSoMany) {
  std::vector<double> values;
  for (int i = 250; i > 0; --i) {
    values.push_back(i);
  }
  EXPECT_EQ(quantileExceededBy(values, 100), 248.0);
  EXPECT_EQ(quantileExceededBy(values, 2), 126.0);
}

TEST(QuantileExceededBy, isTheLargestOfFewValues) {
  std::vector<double> values{3.0, 1.0, 2.0};
  EXPECT_EQ(quantileExceededBy(values, 100), 3.0);
}

TEST(QuantileExceededBy, isZeroWithoutValues) {
  std::vector<double> values;
  EXPECT_EQ(quantileExceededBy(values, 2), 0.0);
}

}  // namespace
}  // namespace drape::sim
