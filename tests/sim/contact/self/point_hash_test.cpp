#include "sim/contact/self/point_hash.hpp"

#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace drape::sim::contact {
namespace {

using Phase = std::array<float, 3>;

constexpr Phase noPhase = {0.0F, 0.0F, 0.0F};

/// Random points in a box of the given size [m], in ascending order of patches.
SurfacePoints cloud(int count, int patches, double size, unsigned seed) {
  testing::RandomVectors random(seed);
  SurfacePoints points;
  points.resize(count);
  points.count = count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const Vec3 position = random.next(size);
    points.positions.x[i] = static_cast<float>(position.x());
    points.positions.y[i] = static_cast<float>(position.y());
    points.positions.z[i] = static_cast<float>(position.z());
    points.patch[i] = static_cast<std::int32_t>(i) * patches / count;
    points.vertex[i] = static_cast<std::int32_t>(i);
  }
  return points;
}

Vec3 positionOf(const SurfacePoints& points, int i) {
  const auto at = static_cast<std::size_t>(i);
  return Vec3(static_cast<double>(points.positions.x[at]), static_cast<double>(points.positions.y[at]),
              static_cast<double>(points.positions.z[at]));
}

std::vector<VertexPair> pairsOf(const SurfacePoints& points, float reach, const Phase& phase = noPhase) {
  PointHash hash;
  std::vector<VertexPair> pairs;
  hash.findPairs(points, reach, phase, pairs);
  return pairs;
}

/// The cell of a point, computed independently of the hash. `offset` is the shift of the grid [m].
std::array<double, 3> cellOf(const SurfacePoints& points, int i, double size, double offset) {
  const LaneBox box = boxOf(points.positions, 0, points.count);
  const Vec3 position = positionOf(points, i);
  std::array<double, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double from = static_cast<double>(box.low[axis]) - offset;
    cell[axis] = std::floor((position[static_cast<Eigen::Index>(axis)] - from) / size);
  }
  return cell;
}

TEST(PointHash, FindsExactlyTheNearPairsOfDifferentPatchesThatShareACellOfEitherGrid) {
  // There are enough buckets, so each bucket is one cell.
  const SurfacePoints points = cloud(600, 5, 0.2, 1);
  const float reach = 0.03F;
  const double size = static_cast<double>(PointHash::cellsPerReach) * 0.03;
  std::set<std::pair<int, int>> expected;
  int missed = 0;
  for (int i = 0; i < points.count; ++i) {
    for (int j = i + 1; j < points.count; ++j) {
      const bool other = points.patch[i] != points.patch[j];
      if (!other || (positionOf(points, i) - positionOf(points, j)).norm() >= 0.03) {
        continue;
      }
      const bool met = cellOf(points, i, size, 0.0) == cellOf(points, j, size, 0.0) ||
                       cellOf(points, i, 2.0 * size, 0.5 * size) == cellOf(points, j, 2.0 * size, 0.5 * size);
      met ? static_cast<void>(expected.insert({i, j})) : static_cast<void>(++missed);
    }
  }
  std::set<std::pair<int, int>> found;
  for (const VertexPair& pair : pairsOf(points, reach)) {
    EXPECT_TRUE(found.insert({pair.a, pair.b}).second) << "pair " << pair.a << " " << pair.b << " came twice";
  }
  EXPECT_EQ(found, expected);
  EXPECT_GT(expected.size(), 200u);
  EXPECT_GT(missed, 0);
}

TEST(PointHash, FindsNoOtherPairsWhereManyCellsShareABucket) {
  const SurfacePoints points = cloud(500, 4, 10.0, 2);
  const std::vector<VertexPair> pairs = pairsOf(points, 0.9F);
  ASSERT_FALSE(pairs.empty());
  for (const VertexPair& pair : pairs) {
    EXPECT_LT((positionOf(points, pair.a) - positionOf(points, pair.b)).norm(), 0.9);
    EXPECT_NE(points.patch[pair.a], points.patch[pair.b]);
  }
}

/// Pairs of points of two patches with given offsets, each pair far from the others.
SurfacePoints isolatedPairs(const std::vector<Vec3>& offsets, unsigned seed) {
  testing::RandomVectors random(seed);
  SurfacePoints points;
  const auto count = offsets.size();
  points.resize(2 * count);
  points.count = static_cast<int>(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 position =
        Vec3(static_cast<double>(i % 20), static_cast<double>(i / 20 % 20), static_cast<double>(i / 400)) +
        random.next(0.4);
    for (std::size_t end = 0; end < 2; ++end) {
      const Vec3 at = position + static_cast<double>(end) * offsets[i];
      points.positions.x[i + end * count] = static_cast<float>(at.x());
      points.positions.y[i + end * count] = static_cast<float>(at.y());
      points.positions.z[i + end * count] = static_cast<float>(at.z());
      points.patch[i + end * count] = static_cast<std::int32_t>(end);
      points.vertex[i + end * count] = static_cast<std::int32_t>(i + end * count);
    }
  }
  return points;
}

TEST(PointHash, MissesNoPairThatLiesAlongAnAxis) {
  std::vector<Vec3> offsets;
  for (int i = 0; i < 3000; ++i) {
    offsets.push_back(0.0099 * Vec3::Unit(i % 3));
  }
  EXPECT_EQ(pairsOf(isolatedPairs(offsets, 3), 0.01F).size(), offsets.size());
}

TEST(PointHash, MissesThePredictedFractionOfPairs) {
  testing::RandomVectors random(4);
  std::vector<Vec3> offsets;
  while (offsets.size() < 8000) {
    const Vec3 direction = random.next(1.0);
    if (direction.norm() < 1.0) {
      offsets.emplace_back(0.0099 * direction.normalized());
    }
  }
  const SurfacePoints points = isolatedPairs(offsets, 5);
  const double expected = PointHash::missedFraction(0.0099, 0.01);
  double missed = 0.0;
  constexpr int phases = 8;
  for (int i = 0; i < phases; ++i) {
    const auto part = static_cast<float>(i);
    const auto found = pairsOf(points, 0.01F, {part * 0.31F, part * 0.47F, part * 0.73F}).size();
    missed += 1.0 - static_cast<double>(found) / static_cast<double>(offsets.size());
  }
  EXPECT_NEAR(missed / phases, expected, 0.1 * expected);
  EXPECT_NEAR(expected, 0.13, 0.02);
  EXPECT_NEAR(PointHash::missedFraction(0.005, 0.01), 0.042, 0.01);
}

TEST(PointHash, ReportsWhichPairsItHasCompared) {
  const SurfacePoints points = cloud(300, 3, 0.2, 6);
  PointHash hash;
  std::vector<VertexPair> pairs;
  hash.findPairs(points, 0.03F, noPhase, pairs);
  std::set<std::pair<int, int>> found;
  for (const VertexPair& pair : pairs) {
    found.insert({pair.a, pair.b});
  }
  for (int i = 0; i < points.count; ++i) {
    for (int j = i + 1; j < points.count; ++j) {
      const bool near = (positionOf(points, i) - positionOf(points, j)).norm() < 0.03;
      const bool other = points.patch[i] != points.patch[j];
      if (near && other) {
        EXPECT_EQ(found.count({i, j}) > 0, hash.compared(i, j));
      }
    }
  }
}

TEST(PointHash, AcceptsNoneOneAndManyPointsAtOnePosition) {
  EXPECT_TRUE(pairsOf(cloud(1, 1, 0.1, 7), 0.01F).empty());
  SurfacePoints none;
  none.resize(0);
  EXPECT_TRUE(pairsOf(none, 0.01F).empty());
  EXPECT_EQ(pairsOf(cloud(40, 2, 0.0, 8), 0.01F).size(), 20u * 20u);
  EXPECT_TRUE(pairsOf(cloud(40, 1, 0.0, 8), 0.01F).empty());
}

TEST(HashGrid, GivesEachCellABucketIfThereAreEnough) {
  const LaneBox box = {{0.0F, 0.0F, 0.0F}, {1.0F, 0.4F, 0.1F}};
  const HashGrid grid = hashGridOver(box, {0.0F, 0.0F, 0.0F}, 0.1F, 30);
  EXPECT_EQ(grid.bits, (std::array<int, 3>{4, 3, 2}));
  EXPECT_EQ(hashGridOver(box, {0.0F, 0.0F, 0.0F}, 0.1F, 6).buckets(), 64);
}

}  // namespace
}  // namespace drape::sim::contact
