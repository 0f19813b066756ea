#include "sim/simd/step_origin.hpp"

#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace drape::sim::simd {
namespace {

using testing::sheet;

std::vector<Vec3> shifted(std::vector<Vec3> positions, const Vec3& by) {
  for (Vec3& position : positions) {
    position += by;
  }
  return positions;
}

TEST(StepOrigin, isNearTheMiddleOfTheCloth) {
  for (const Vec3& by : {Vec3(0.0, 0.0, 0.0), Vec3(10.3, -7.1, 250.0), Vec3(1e6, 0.0, 3.0)}) {
    const std::vector<Vec3> positions = shifted(sheet(20).positions, by);
    const Vec3 origin = stepOrigin<float>(positions);
    for (const Vec3& position : positions) {
      EXPECT_LT((position - origin).cwiseAbs().maxCoeff(), 0.75);
    }
  }
}

TEST(StepOrigin, movesWithTheCloth) {
  const std::vector<Vec3> positions = sheet(9).positions;
  const Vec3 by(64.0, -32.0, 128.0);
  EXPECT_EQ(stepOrigin<float>(shifted(positions, by)), stepOrigin<float>(positions) + by);
}

TEST(StepOrigin, isKeptWhileTheClothMovesLittle) {
  const std::vector<Vec3> positions = shifted(sheet(9).positions, Vec3(5.1, 5.1, 5.1));
  EXPECT_EQ(stepOrigin<float>(shifted(positions, Vec3(0.02, -0.02, 0.02))), stepOrigin<float>(positions));
}

TEST(StepOrigin, isZeroInDoubleAndForPositionsThatAreNotFinite) {
  std::vector<Vec3> positions = shifted(sheet(9).positions, Vec3(10.0, 10.0, 10.0));
  EXPECT_EQ(stepOrigin<double>(positions), Vec3(0.0, 0.0, 0.0));
  positions[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(stepOrigin<float>(positions), Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(stepOrigin<float>({}), Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(stepOrigin<float>(std::vector<Vec3>(5, Vec3(3.0, 3.0, 3.0))), Vec3(0.0, 0.0, 0.0));
}

}  // namespace
}  // namespace drape::sim::simd
