#include "sim/model/workers.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace drape::sim {
namespace {

/// The ranges that a loop of `count` indices is divided into, ascending.
std::vector<std::pair<int, int>> unevenRanges(int threads, int count) {
  Workers workers;
  std::mutex mutex;
  std::vector<std::pair<int, int>> ranges;
  workers.forUnevenRange(threads, count, [&](int begin, int end) {
    const std::lock_guard lock(mutex);
    ranges.emplace_back(begin, end);
  });
  std::sort(ranges.begin(), ranges.end());
  return ranges;
}

TEST(Workers, visitEachIndexOfAnUnevenLoopOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    for (const int count : {0, 1, 63, 64, 65, 870, 5000}) {
      int next = 0;
      for (const auto& [begin, end] : unevenRanges(threads, count)) {
        EXPECT_EQ(begin, next);
        next = end;
      }
      EXPECT_EQ(next, count) << threads << " threads";
    }
  }
}

TEST(Workers, divideUnevenLoopsIntoMoreRangesThanThreads) {
  EXPECT_EQ(unevenRanges(1, 870).size(), 1U);
  EXPECT_GE(unevenRanges(2, 870).size(), 8U);
  EXPECT_EQ(unevenRanges(2, 20).size(), 1U);
}

}  // namespace
}  // namespace drape::sim
