#include "sim/measures/accuracy.hpp"

#include "sim/measures/measures.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace drape::sim {
namespace {

TEST(Accuracy, displacesAllVerticesButPinsByAMicrometreAndAlwaysInTheSameWay) {
  constexpr std::size_t count = 50;
  std::vector<bool> pinned(count, false);
  pinned[7] = true;
  const std::vector<Vec3> start(count, Vec3(1.0, -2.0, 0.5));
  std::vector<Vec3> first = start;
  displaceForTest(pinned, first);
  std::vector<Vec3> second = start;
  displaceForTest(pinned, second);
  EXPECT_EQ(first, second);
  for (std::size_t v = 0; v < count; ++v) {
    EXPECT_NEAR((first[v] - start[v]).norm(), pinned[v] ? 0.0 : testDisplacement, 1e-12) << v;
  }
  EXPECT_GT((first[0] - first[1]).norm(), 0.1 * testDisplacement) << "each in its own direction";
}

TEST(Accuracy, isNotKnownWhereTinyDifferencesGrowToTheSizeOfTheError) {
  EXPECT_TRUE(isErrorKnown({.error = 2e-3, .spread = 3e-6})) << "the difference has hardly grown";
  EXPECT_TRUE(isErrorKnown({.error = 2e-2, .spread = 2e-3})) << "it has grown, but the error is larger";
  EXPECT_TRUE(isErrorKnown({.error = 1e-6, .spread = 2e-6})) << "both are negligible";
  EXPECT_FALSE(isErrorKnown({.error = 2e-2, .spread = 1e-2}));
}

}  // namespace
}  // namespace drape::sim
