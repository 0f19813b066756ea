#include "sim/adaptive/coarse_levels.hpp"

#include "sim/adaptive/coarse_motion.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace drape::sim::adaptive {
namespace {

using testing::irregularSheet;
using testing::pinnedSheet;

TEST(CoarseLevels, containEveryVertexConserveMassAndShrinkToAFewAggregates) {
  const auto model = irregularSheet(33, {0, 32});
  const auto levels = buildCoarseLevels(*model);
  ASSERT_GE(levels.size(), 3U);
  EXPECT_LE(levels.back().cloth->vertexCount(), 12);
  const ClothModel* finer = model.get();
  for (const CoarseLevel& level : levels) {
    ASSERT_EQ(level.aggregateOf.size(), finer->restPositions.size());
    std::vector<int> members(level.cloth->restPositions.size(), 0);
    for (const int aggregate : level.aggregateOf) {
      ++members.at(static_cast<std::size_t>(aggregate));
    }
    EXPECT_GT(*std::min_element(members.begin(), members.end()), 0);
    EXPECT_NEAR(level.cloth->totalMass(), model->totalMass(), 1e-12);
    EXPECT_LT(level.cloth->vertexCount(), finer->vertexCount());
    finer = level.cloth.get();
  }
}

TEST(CoarseLevels, keepPinnedVerticesInSeparateAggregatesConnectedToOthers) {
  const auto model = pinnedSheet(17);
  for (const CoarseLevel& level : buildCoarseLevels(*model)) {
    const ClothModel& aggregates = *level.cloth;
    ASSERT_EQ(std::count(aggregates.pinned.begin(), aggregates.pinned.end(), true), 2);
    for (std::size_t g = 0; g < aggregates.pinned.size(); ++g) {
      if (aggregates.pinned[g]) {
        EXPECT_FALSE(aggregates.springEnds[g].empty());
      }
    }
  }
  const CoarseLevel first = buildCoarseLevels(*model).front();
  EXPECT_EQ(first.cloth->restPositions[first.aggregateOf[0]], model->restPositions[0]);
}

TEST(CoarseLevels, formStraightRowsAlongAFreeEdge) {
  constexpr int n = 33;
  const auto model = pinnedSheet(n);
  const CoarseLevel first = buildCoarseLevels(*model).front();
  const ClothModel& aggregates = *first.cloth;
  EXPECT_NEAR(aggregates.vertexCount(), n * n / 4, n) << "every second vertex of every second row";
  // The last row is free: its aggregates, except those at the corners, have the same depth in the sheet.
  std::vector<double> depths;
  for (int column = 4; column < n - 4; ++column) {
    const auto aggregate = static_cast<std::size_t>(first.aggregateOf[(n - 1) * n + column]);
    depths.push_back(aggregates.restPositions[aggregate].z());
  }
  const auto [smallest, largest] = std::minmax_element(depths.begin(), depths.end());
  EXPECT_LT(*largest - *smallest, 0.15 / (n - 1)) << "a zigzag row straightens before it carries load";
}

TEST(CoarseLevels, coarsenAClosedSurfaceWithoutBoundaryAndPins) {
  constexpr int round = 12;
  ClothMesh torus;
  for (int i = 0; i < round; ++i) {
    for (int j = 0; j < round; ++j) {
      const double a = 2.0 * std::numbers::pi * i / round;
      const double b = 2.0 * std::numbers::pi * j / round;
      const double radius = 2.0 + std::cos(b);
      torus.positions.emplace_back(radius * std::cos(a), std::sin(b), radius * std::sin(a));
      const int right = (i + 1) % round * round;
      const int next = (j + 1) % round;
      torus.triangles.push_back({i * round + j, right + j, right + next});
      torus.triangles.push_back({i * round + j, right + next, i * round + next});
    }
  }
  const auto levels = buildCoarseLevels(*buildClothModel(torus, 1.0, MassLumping::Area, {}));
  ASSERT_GE(levels.size(), 2U);
  EXPECT_LT(3 * levels.front().cloth->vertexCount(), round * round);
  EXPECT_LE(levels.back().cloth->vertexCount(), 12);
}

TEST(CoarseLevels, areNoneForSeparateTriangles) {
  ClothMesh mesh;
  for (int piece = 0; piece < 8; ++piece) {
    const double x = 2.0 * piece;
    const int first = 3 * piece;
    mesh.positions.insert(mesh.positions.end(), {Vec3(x, 0, 0), Vec3(x + 1, 0, 0), Vec3(x, 0, 1)});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(buildCoarseLevels(*buildClothModel(mesh, 1.0, MassLumping::Area, {})).empty());
}

/// The accelerations of a cloth by its levels, one a vertex.
std::vector<Vec3> accelerationsOf(const ClothModel& model, const std::vector<Vec3>& positions) {
  simd::SlicedCloth<double> cloth(model);
  cloth.prepare(1, 1);
  ClothState state = stateAtRest(positions);
  cloth.load(state, simd::shareOf(cloth.layout, 1, 0, 1));
  CoarseMotion<double> motion(buildCoarseLevels(model), model, cloth);
  EXPECT_GT(motion.setStiffness(1000.0, 900.0, 1.4, 1e-3), 1);
  motion.accelerate(cloth, false);
  std::vector<Vec3> accelerations;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const int aggregate = motion.aggregates()[cloth.layout.indexOf[v]];
    const auto& from = motion.accelerations();
    accelerations.emplace_back(from.x.data()[aggregate], from.y.data()[aggregate], from.z.data()[aggregate]);
  }
  return accelerations;
}

TEST(CoarseMotion, keepsTheMomentumOfStretchedFreeCloth) {
  const auto model = irregularSheet(17, {});
  std::vector<Vec3> positions = testing::shaken(*model, 0.02, 4).positions;
  for (Vec3& position : positions) {
    position = Vec3(1.2 * position.x(), position.y() + 0.2 * position.x() * position.x(), 1.1 * position.z());
  }
  const std::vector<Vec3> accelerations = accelerationsOf(*model, positions);
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
  double size = 0.0;
  for (std::size_t v = 0; v < accelerations.size(); ++v) {
    force += model->vertexMass[v] * accelerations[v];
    torque += positions[v].cross(model->vertexMass[v] * accelerations[v]);
    size += model->vertexMass[v] * accelerations[v].norm();
  }
  EXPECT_GT(size, 0.1);
  EXPECT_LT(force.norm(), 1e-12 * size);
  EXPECT_LT(torque.norm(), 1e-12 * size);
}

TEST(CoarseMotion, doesNothingToClothThatIsCompressedOrAtRest) {
  const auto model = pinnedSheet(17);
  for (const double scale : {1.0, 0.7}) {
    std::vector<Vec3> positions = model->restPositions;
    for (Vec3& position : positions) {
      position *= scale;
    }
    for (const Vec3& acceleration : accelerationsOf(*model, positions)) {
      EXPECT_LT(acceleration.norm(), 1e-6);
    }
  }
}

}  // namespace
}  // namespace drape::sim::adaptive
