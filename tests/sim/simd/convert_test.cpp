#include "sim/simd/convert.hpp"

#include <gtest/gtest.h>
#include <bit>
#include <cstdint>
#include <vector>

namespace drape::sim::simd {
namespace {

/// Sums that overflow many times; the sanitizers must have nothing to say.
TEST(SumOfBits, isTheSumOfTheBitsOfAllNumbersForAnyCount) {
  for (const int count : {0, 1, 3, 8, 9, 64, 1001}) {
    std::vector<double> values;
    std::uint64_t sum = 0;
    for (int i = 0; i < count; ++i) {
      values.push_back((i % 2 == 0 ? -1.7e300 : 3.1) * (i + 1));
      sum += std::bit_cast<std::uint64_t>(values.back());
    }
    EXPECT_EQ(sumOfBits(values.data(), values.size()), sum) << count;
  }
}

}  // namespace
}  // namespace drape::sim::simd
