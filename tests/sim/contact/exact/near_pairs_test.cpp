#include "sim/contact/exact/near_pairs.hpp"

#include "sim/contact/closest_features/triangle_geometry.hpp"
#include "sim/contact/exact/feature_patches.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace drape::sim::contact {
namespace {

Vec3 randomPoint(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> coordinate(-size, size);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

/// Tetrahedra of four vertices each. Some are flat, some have parallel edges, some have an edge of length 0, and all
/// lie far from the origin.
std::vector<Vec3> tetrahedra(int count, std::mt19937& random) {
  std::vector<Vec3> positions;
  for (int i = 0; i < count; ++i) {
    const Vec3 middle = Vec3(40.0, -30.0, 20.0) + randomPoint(random, 1.0);
    std::array<Vec3, 4> corners;
    for (Vec3& corner : corners) {
      corner = middle + randomPoint(random, 0.1);
      corner.y() = i % 4 == 1 ? middle.y() : corner.y();
    }
    corners[3] = i % 4 == 2 ? Vec3(corners[2] + 0.7 * (corners[1] - corners[0])) : corners[3];
    corners[1] = i % 4 == 3 ? corners[0] : corners[1];
    positions.insert(positions.end(), corners.begin(), corners.end());
  }
  return positions;
}

/// The points after a small random motion.
std::vector<Vec3> moved(std::vector<Vec3> points, std::mt19937& random) {
  for (Vec3& point : points) {
    point += randomPoint(random, 0.05);
  }
  return points;
}

/// A pair of features in each of `count` tetrahedra.
PairLanes lanesOf(int count) {
  PairLanes lanes;
  for (int i = 0; i < count; ++i) {
    lanes.add({4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
  }
  return lanes;
}

TEST(PairDistances, areTheSeparationsOfTheScalarComputation) {
  std::mt19937 random(3);
  constexpr int count = 1001;
  const std::vector<Vec3> start = tetrahedra(count, random);
  const std::vector<Vec3> end = moved(start, random);
  for (const bool edges : {false, true}) {
    PairLanes lanes = lanesOf(count);
    std::vector<double> distances;
    Approach approach;
    measureDistances(edges, lanes, start.data(), distances);
    measureApproach(edges, lanes, start.data(), end.data(), approach);
    for (int i = 0; i < count; ++i) {
      const PairVertices vertices{{4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3}, edges ? 2U : 1U};
      const PairGap gap = gapOf(vertices, start);
      ASSERT_LE(distances[i], gap.distance + 1e-12) << i;
      if (gap.distance > 1e-6) {
        ASSERT_NEAR(distances[i], gap.distance, 1e-7) << i;
        ASSERT_NEAR(approach.start[i], separationAlong(gap.normal, vertices, start), 1e-7) << i;
        ASSERT_NEAR(approach.end[i], separationAlong(gap.normal, vertices, end), 1e-7) << i;
      }
    }
  }
}

TEST(PairDistances, findTheGapsOfContactsOfTheScalarComputation) {
  std::mt19937 random(4);
  constexpr int count = 1001;
  const std::vector<Vec3> start = tetrahedra(count, random);
  const std::vector<Vec3> end = moved(start, random);
  for (const bool edges : {false, true}) {
    PairLanes lanes = lanesOf(count);
    std::vector<double> gaps;
    measureContactGaps(edges, lanes, start.data(), end.data(), gaps);
    int ends = 0;
    int exact = 0;
    for (int i = 0; i < count; ++i) {
      const PairGap gap = gapOf({{4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3}, edges ? 2U : 1U}, start);
      double predicted = 0.0;
      for (int k = 0; k < 4; ++k) {
        predicted += gap.weights[k] * gap.normal.dot(end[4 * i + k] - end[4 * i]);
      }
      if (std::isinf(gaps[i])) {
        ++ends;
        ASSERT_TRUE(edges && !(isInside(gap.weights[1]) && isInside(-gap.weights[3]))) << i;
      } else if (gaps[i] != 0.0 && gap.distance > 1e-6) {
        ++exact;
        ASSERT_NEAR(gaps[i], std::min(gap.distance, predicted), 1e-7) << i;
      }
    }
    EXPECT_EQ(ends > 0, edges);
    EXPECT_GT(exact, count / 20);
  }
}

/// The minimum distance of a pair on straight ways, by samples [m].
double minDistanceOnTheWay(const PairVertices& vertices, const std::vector<Vec3>& start, const std::vector<Vec3>& end) {
  double minimum = std::numeric_limits<double>::infinity();
  std::vector<Vec3> at = start;
  for (int k = 0; k <= 200; ++k) {
    for (std::size_t v = 0; v < at.size(); ++v) {
      at[v] = start[v] + k / 200.0 * (end[v] - start[v]);
    }
    minimum = std::min(minimum, gapOf(vertices, at).distance);
  }
  return minimum;
}

TEST(ComesWithin, isTrueForPairsThatComeCloserAndFalseForThoseThatStayFarther) {
  std::mt19937 random(5);
  constexpr double distance = 0.03;
  int closer = 0;
  int farther = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<Vec3> start;
    std::vector<Vec3> end;
    for (int k = 0; k < 4; ++k) {
      start.push_back(randomPoint(random, 0.1));
      end.push_back(start.back() + randomPoint(random, 0.1));
    }
    const PairVertices vertices{{0, 1, 2, 3}, i % 2 == 0 ? 1U : 2U};
    const double minimum = minDistanceOnTheWay(vertices, start, end);
    const bool within = comesWithin(distance, vertices, start, end);
    if (minimum <= distance) {
      EXPECT_TRUE(within) << i;
      ++closer;
    }
    if (minimum >= 1.01 * approachSlack * distance) {  // samples can miss the minimum
      EXPECT_FALSE(within) << i;
      ++farther;
    }
  }
  EXPECT_GT(closer, 100);
  EXPECT_GT(farther, 100);
}

TEST(FeatureBoxes, findsAllOverlapsOfTwoLeavesAndOnlyThose) {
  const auto model = buildClothModel(testing::sheet(9), 1.0, MassLumping::Uniform, {});
  const FeatureMesh mesh = featureMeshOf(*model);
  const MeshTree tree(model->restPositions, mesh.triangles, 8);
  LeafBoxes boxes(mesh, tree);
  std::mt19937 random(1);
  std::vector<Vec3> low = model->restPositions;
  std::vector<Vec3> high = low;
  for (std::size_t v = 0; v < low.size(); ++v) {
    high[v] += 0.1 * (randomPoint(random, 1.0) + Vec3::Ones());
  }
  boxes.fit(mesh, low, high);
  const auto boxOf = [&](int v) { return Eigen::AlignedBox3d(low[v], high[v]); };
  int found = 0;
  for (std::size_t a = 0; a < tree.leafCount(); ++a) {
    for (std::size_t b = 0; b < tree.leafCount(); ++b) {
      std::vector<OverlappingBoxes> overlaps;
      findOverlaps(boxes.vertices(), a, boxes.triangles(), b, overlaps);
      int expected = 0;
      for (int i = 0; i < boxes.vertices().count[a]; ++i) {
        for (const int t : tree.leaf(b)) {
          const auto& [x, y, z] = mesh.triangles[t];
          const int v = boxes.vertices().features[boxes.vertices().begin[a] + i];
          const bool meets = boxOf(v).intersects(boxOf(x).merged(boxOf(y)).merged(boxOf(z)));
          expected += meets ? 1 : 0;
        }
      }
      EXPECT_EQ(static_cast<int>(overlaps.size()), expected);
      found += expected;
    }
  }
  EXPECT_GT(found, 100);
}

TEST(FeaturePatches, containOnlyFeaturesWhoseTrianglesAllBelongToThePatch) {
  ClothMesh sheet = testing::sheet(17);
  for (Vec3& position : sheet.positions) {
    position.y() = position.x() < 0.5 ? 0.0 : 4.0 * (position.x() - 0.5);  // bent by 76 degrees
  }
  const auto model = buildClothModel(sheet, 1.0, MassLumping::Uniform, {});
  const FeatureMesh mesh = featureMeshOf(*model);
  PatchFinder finder;
  const PatchHistory history = finder.update(*model, model->restPositions, {});
  const SharedFeaturePatches features = finder.ofFeatures(mesh, history);
  ASSERT_GT(history.patches->count(), 1);
  int between = 0;
  for (int v = 0; v < model->vertexCount(); ++v) {
    const std::span<const int> around = model->vertexTriangles[v];
    const int first = features->ofTriangle[around.front()];
    const bool same =
        std::all_of(around.begin(), around.end(), [&](int t) { return features->ofTriangle[t] == first; });
    EXPECT_EQ(features->ofVertex[v], same ? first : -1);
    between += same ? 0 : 1;
  }
  EXPECT_GT(between, 10);
}

TEST(FeaturePatches, areRemovedWhereAPatchIsNoLongerCollisionFree) {
  const auto model = buildClothModel(testing::sheet(17), 1.0, MassLumping::Uniform, {});
  const FeatureMesh mesh = featureMeshOf(*model);
  PatchFinder finder;
  SharedFeaturePatches features = finder.ofFeatures(mesh, finder.update(*model, model->restPositions, {}));
  EXPECT_FALSE(finder.removeInvalid(model->restPositions, features));
  EXPECT_EQ(std::count(features->ofVertex.begin(), features->ofVertex.end(), -1), 0);
  std::vector<Vec3> folded = model->restPositions;
  for (Vec3& position : folded) {
    position = position.x() < 0.5 ? position : Vec3(1.0 - position.x(), 0.01, position.z());
  }
  EXPECT_TRUE(finder.removeInvalid(folded, features));
  EXPECT_EQ(std::count(features->ofVertex.begin(), features->ofVertex.end(), -1), model->vertexCount());
}

}  // namespace
}  // namespace drape::sim::contact
