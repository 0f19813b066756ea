#include "sim/contact/exact/near_pairs.hpp"

#include "contact/exact/common_end.hpp"
#include "sim/contact/closest_features/triangle_geometry.hpp"
#include "sim/contact/exact/feature_patches.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

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

/// The boxes of a sheet, of random sizes.
struct RandomBoxes {
  RandomBoxes()
      : model(buildClothModel(testing::sheet(9), 1.0, MassLumping::Uniform, {})),
        mesh(featureMeshOf(*model)),
        tree(model->restPositions, mesh.triangles, 8),
        boxes(mesh, tree),
        low(model->restPositions),
        high(low) {
    std::mt19937 random(1);
    for (Vec3& corner : high) {
      corner += 0.1 * (randomPoint(random, 1.0) + Vec3::Ones());
    }
    boxes.fit(low, high);
  }

  [[nodiscard]] Eigen::AlignedBox3d around(std::span<const int> vertices) const {
    Eigen::AlignedBox3d box;
    for (const int v : vertices) {
      box.extend(Eigen::AlignedBox3d(low[v], high[v]));
    }
    return box;
  }

  std::shared_ptr<const ClothModel> model;
  FeatureMesh mesh;
  MeshTree tree;
  LeafBoxes boxes;
  std::vector<Vec3> low, high;
};

std::vector<int> featuresOf(const FeatureBoxes& boxes, std::size_t leaf) {
  std::vector<int> features;
  forEachFeature(boxes, boxes.leaves[leaf],
                 [&](const FeatureBlock& block, std::size_t lane) { features.push_back(block.features[lane]); });
  return features;
}

TEST(FeatureBoxes, findsAllOverlapsOfTwoLeavesAndOnlyThose) {
  const RandomBoxes sheet;
  int found = 0;
  int withoutCommon = 0;
  for (std::size_t a = 0; a < sheet.tree.leafCount(); ++a) {
    for (std::size_t b = 0; b < sheet.tree.leafCount(); ++b) {
      int expected = 0;
      int expectedWithoutCommon = 0;
      for (const int v : featuresOf(sheet.boxes.vertices(), a)) {
        for (const int t : featuresOf(sheet.boxes.triangles(), b)) {
          const bool meets = sheet.around({&v, 1}).intersects(sheet.around(sheet.mesh.triangles[t]));
          expected += meets ? 1 : 0;
          expectedWithoutCommon += meets && !hasCorner(sheet.mesh.triangles[t], v) ? 1 : 0;
        }
      }
      std::vector<OverlappingBoxes> overlaps;
      findOverlaps(sheet.boxes.vertices(), a, sheet.boxes.triangles(), b, CommonVertices::Permitted, overlaps);
      EXPECT_EQ(static_cast<int>(overlaps.size()), expected);
      findOverlaps(sheet.boxes.vertices(), a, sheet.boxes.triangles(), b, CommonVertices::LeftOut, overlaps);
      EXPECT_EQ(static_cast<int>(overlaps.size()), expectedWithoutCommon);
      found += expected;
      withoutCommon += expectedWithoutCommon;
    }
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(withoutCommon, 20);
}

TEST(FeatureBoxes, findsEdgesThatOverlapWithoutACommonEnd) {
  const RandomBoxes sheet;
  const auto endsOf = [&](int e) {
    return std::array<int, 2>{sheet.mesh.edges.edges[e].a, sheet.mesh.edges.edges[e].b};
  };
  int found = 0;
  for (std::size_t a = 0; a < sheet.tree.leafCount(); ++a) {
    for (std::size_t b = a; b < sheet.tree.leafCount(); ++b) {
      std::vector<std::array<int, 2>> expected;
      for (const int e : featuresOf(sheet.boxes.edges(), a)) {
        for (const int f : featuresOf(sheet.boxes.edges(), b)) {
          const bool haveCommon = testing::shareEnd(sheet.mesh.edges.edges[e], sheet.mesh.edges.edges[f]);
          const bool isFirst = a != b || e < f;
          if (isFirst && !haveCommon && sheet.around(endsOf(e)).intersects(sheet.around(endsOf(f)))) {
            expected.push_back({std::min(e, f), std::max(e, f)});
          }
        }
      }
      std::vector<OverlappingBoxes> overlaps;
      findOverlaps(sheet.boxes.edges(), a, sheet.boxes.edges(), b, CommonVertices::LeftOut, overlaps);
      std::vector<std::array<int, 2>> pairs;
      for (const auto& [e, f] : overlaps) {
        pairs.push_back({std::min(e, f), std::max(e, f)});
      }
      std::ranges::sort(pairs);
      std::ranges::sort(expected);
      EXPECT_EQ(pairs, expected);
      found += static_cast<int>(expected.size());
    }
  }
  EXPECT_GT(found, 20);
}

/// A reach that is longer than the edges of the sheets below, so that there are patches across borders [m].
constexpr double reachOnFineMesh = 0.1;

TEST(FeaturePatches, containOnlyFeaturesWhoseTrianglesAllBelongToThePatch) {
  ClothMesh sheet = testing::sheet(17);
  for (Vec3& position : sheet.positions) {
    position.y() = position.x() < 0.5 ? 0.0 : 4.0 * (position.x() - 0.5);  // bent by 76 degrees
  }
  const auto model = buildClothModel(sheet, 1.0, MassLumping::Uniform, {});
  const FeatureMesh mesh = featureMeshOf(*model);
  PatchFinder finder;
  const PatchHistory history = finder.update(*model, reachOnFineMesh, model->restPositions, {});
  const SharedFeaturePatches features = finder.ofFeatures(mesh, history);
  ASSERT_GT(history.patches->count(), 1);
  ASSERT_GT(history.acrossBorders[0]->count(), 0);
  int between = 0;
  int inNone = 0;
  for (int v = 0; v < model->vertexCount(); ++v) {
    const std::span<const int> around = model->vertexTriangles[v];
    bool isInOne = false;
    for (const PatchLabels& labels : *features) {
      if (labels.patches->count() == 0) {
        continue;
      }
      const int first = labels.ofTriangle[around.front()];
      const bool same = std::all_of(around.begin(), around.end(), [&](int t) { return labels.ofTriangle[t] == first; });
      EXPECT_EQ(labels.ofVertex[v], same ? first : -1);
      isInOne = isInOne || labels.ofVertex[v] >= 0;
    }
    between += features->front().ofVertex[v] < 0 ? 1 : 0;
    inNone += isInOne ? 0 : 1;
  }
  EXPECT_GT(between, 10);
  EXPECT_LT(inNone, between);
}

/// Whether both features of a pair belong to a patch.
bool haveCommonPatch(const FeaturePatches& sets, const FeaturePair& pair) {
  return std::ranges::any_of(sets, [&](const PatchLabels& labels) {
    if (labels.patches->count() == 0) {
      return false;
    }
    const int first = pair.edges ? labels.ofEdge[pair.first] : labels.ofVertex[pair.first];
    const int second = pair.edges ? labels.ofEdge[pair.second] : labels.ofTriangle[pair.second];
    return first >= 0 && first == second;
  });
}

TEST(PairSearch, listsExactlyTheNearPairsWithoutACommonPatch) {
  ClothMesh roll = testing::sheet(17);
  for (Vec3& position : roll.positions) {
    const double angle = 9.0 * position.x();
    position = Vec3((0.2 + 0.012 * angle) * std::cos(angle), (0.2 + 0.012 * angle) * std::sin(angle), position.z());
  }
  const auto model = buildClothModel(roll, 1.0, MassLumping::Uniform, {});
  const FeatureMesh mesh = featureMeshOf(*model);
  const std::vector<Vec3>& at = model->restPositions;
  PatchFinder finder;
  const SharedFeaturePatches patches = finder.ofFeatures(mesh, finder.update(*model, reachOnFineMesh, at, {}));
  PairSearch search;
  Workers workers;
  search.update({.model = *model, .distance = reachOnFineMesh, .reach = reachOnFineMesh, .patches = patches}, at, at,
                workers);
  std::set<std::array<int, 3>> listed;
  for (const PairSearch::Listed& each : search.pairs()) {
    EXPECT_FALSE(haveCommonPatch(*patches, each.pair));
    const auto [low, high] = std::minmax(each.pair.first, each.pair.second);
    listed.insert(each.pair.edges ? std::array{1, low, high} : std::array{0, each.pair.first, each.pair.second});
  }
  int missing = 0;
  const auto check = [&](const FeaturePair& pair) {
    if (!haveCommonPatch(*patches, pair) && gapOf(verticesOf(mesh, pair), at).distance < reachOnFineMesh) {
      missing += listed.contains({pair.edges ? 1 : 0, pair.first, pair.second}) ? 0 : 1;
    }
  };
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    for (int v = 0; v < model->vertexCount(); ++v) {
      if (!hasCorner(mesh.triangles[t], v)) {
        check({v, t, false});
      }
    }
  }
  for (int e = 0; e < static_cast<int>(mesh.edges.edges.size()); ++e) {
    for (int f = e + 1; f < static_cast<int>(mesh.edges.edges.size()); ++f) {
      if (!testing::shareEnd(mesh.edges.edges[e], mesh.edges.edges[f])) {
        check({e, f, true});
      }
    }
  }
  EXPECT_GT(listed.size(), 100U);
  EXPECT_EQ(missing, 0);
}

TEST(FeaturePatches, acrossBordersContainTheFeaturesAtABorder) {
  ClothMesh tube = testing::sheet(33);
  for (Vec3& position : tube.positions) {
    const double angle = 6.0 * position.x();  // nearly a whole turn
    position = Vec3(std::cos(angle), std::sin(angle), position.z());
  }
  const auto model = buildClothModel(tube, 1.0, MassLumping::Uniform, {});
  PatchFinder finder;
  const SharedFeaturePatches features =
      finder.ofFeatures(featureMeshOf(*model), finder.update(*model, reachOnFineMesh, model->restPositions, {}));
  ASSERT_GT(features->front().patches->count(), 2);
  int atBorders = 0;
  int inNone = 0;
  for (int v = 0; v < model->vertexCount(); ++v) {
    const auto isOutside = [&](const PatchLabels& labels) {
      return labels.patches->count() == 0 || labels.ofVertex[v] < 0;
    };
    atBorders += isOutside(features->front()) ? 1 : 0;
    inNone += std::ranges::all_of(*features, isOutside) ? 1 : 0;
  }
  EXPECT_GT(atBorders, 60);
  EXPECT_LT(inNone, atBorders / 10);
}

TEST(FeaturePatches, areRemovedWhereAPatchIsNoLongerCollisionFree) {
  const auto model = buildClothModel(testing::sheet(17), 1.0, MassLumping::Uniform, {});
  const FeatureMesh mesh = featureMeshOf(*model);
  PatchFinder finder;
  SharedFeaturePatches features =
      finder.ofFeatures(mesh, finder.update(*model, reachOnFineMesh, model->restPositions, {}));
  const auto countInNone = [&] { return std::ranges::count(features->front().ofVertex, -1); };
  EXPECT_FALSE(finder.removeInvalid(model->restPositions, features));
  EXPECT_EQ(countInNone(), 0);
  std::vector<Vec3> folded = model->restPositions;
  for (Vec3& position : folded) {
    position = position.x() < 0.5 ? position : Vec3(1.0 - position.x(), 0.01, position.z());
  }
  EXPECT_TRUE(finder.removeInvalid(folded, features));
  EXPECT_EQ(countInNone(), model->vertexCount());
}

}  // namespace
}  // namespace drape::sim::contact
