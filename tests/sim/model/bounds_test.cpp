#include "sim/model/bounds.hpp"

#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace drape::sim {
namespace {

TEST(Bounds, areEmptyWithoutPoints) {
  EXPECT_TRUE(boundsOf({}).isEmpty());
}

TEST(Bounds, areTheLeastAndLargestCoordinatesOfAnyNumberOfPoints) {
  testing::RandomVectors random(3);
  std::vector<Vec3> points;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (int count = 1; count <= 40; ++count) {
    points.push_back(random.next(5.0));
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], points.back()[axis]);
      high[axis] = std::max(high[axis], points.back()[axis]);
    }
    EXPECT_EQ(boundsOf(points).min(), low) << count;
    EXPECT_EQ(boundsOf(points).max(), high) << count;
  }
}

}  // namespace
}  // namespace drape::sim
