#include "sim/contact/closest_features/hull_gap.hpp"

#include "sim/contact/closest_features/closest_points.hpp"
#include "sim/contact/closest_features/mesh_in_step.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace drape::sim::contact {
namespace {

using testing::RandomVectors;

SearchableMesh ball() {
  const BodySurface surface = surfaceOf(SphereShape{0.3});
  return SearchableMesh({surface.positions, surface.triangles, {}, 1.0, false});
}

std::vector<std::int32_t> allLeaves(const SearchableMesh& mesh) {
  std::vector<std::int32_t> leaves(mesh.tree.leafCount());
  std::iota(leaves.begin(), leaves.end(), 0);
  return leaves;
}

/// Distance of a triangle and a mesh, pair by pair [m]; 0 or less if they intersect.
double distanceTo(const SearchableMesh& mesh, const Corners& corners) {
  double minimum = std::numeric_limits<double>::infinity();
  for (const Triangle& triangle : mesh.shape.triangles) {
    minimum = std::min(minimum, gapOfTriangles(corners, cornersOf(mesh.shape.positions, triangle)).distance);
  }
  return minimum;
}

Corners triangleAround(const Vec3& middle, double size, RandomVectors& random) {
  return {middle + random.next(size), middle + random.next(size), middle + random.next(size)};
}

void expectToBeMeasured(const HullGap& gap, const SearchableMesh& mesh, const Corners& corners) {
  double top = -std::numeric_limits<double>::infinity();
  for (const Vec3& vertex : mesh.shape.positions) {
    top = std::max(top, gap.normal.dot(vertex));
  }
  EXPECT_NEAR(gap.normal.norm(), 1.0, 1e-12);
  EXPECT_NEAR(gap.top, top, 1e-14);
  EXPECT_NEAR(gap.atLeast, lowestAlong(gap.normal, corners) - top, 1e-14);
}

TEST(HullGap, isTheDistanceToAConvexMeshForAnyInitialDirection) {
  const SearchableMesh mesh = ball();
  const std::vector<std::int32_t> leaves = allLeaves(mesh);
  RandomVectors random(3);
  int apart = 0;
  for (int i = 0; i < 60; ++i) {
    const Vec3 middle = 0.34 * random.next(1.0).normalized();
    const Corners corners = triangleAround(middle, 0.04, random);
    const double distance = distanceTo(mesh, corners);
    if (distance < 1e-3) {
      continue;
    }
    ++apart;
    const Vec3 along = random.next(1.0).normalized();
    const HullGap gap = HullGapSearch(mesh, false, leaves, corners).search(along, {1.0, 0.9 * distance});
    expectToBeMeasured(gap, mesh, corners);
    EXPECT_LE(gap.atLeast, distance + 1e-12);
    EXPECT_GE(gap.atLeast, 0.9 * distance);
  }
  EXPECT_GT(apart, 20);
}

TEST(HullGap, searchEndsWhenTheGapIsWideEnoughOrCannotBe) {
  const SearchableMesh mesh = ball();
  const std::vector<std::int32_t> leaves = allLeaves(mesh);
  RandomVectors random(4);
  for (int i = 0; i < 40; ++i) {
    const Corners corners = triangleAround(0.33 * random.next(1.0).normalized(), 0.04, random);
    const double exact = distanceTo(mesh, corners);
    const HullGap wide = HullGapSearch(mesh, false, leaves, corners).search(Vec3::UnitX(), {0.005, 0.001});
    expectToBeMeasured(wide, mesh, corners);
    EXPECT_LE(wide.atLeast, exact + 1e-12);
    if (exact > 0.0053) {  // the tolerance is 5 %
      EXPECT_GE(wide.atLeast, 0.005);
    } else if (exact > 0.00106) {
      EXPECT_GE(wide.atLeast, 0.001);
    }
  }
}

TEST(HullGap, isNegativeIfTheHullsIntersect) {
  const SearchableMesh mesh = ball();
  const std::vector<std::int32_t> leaves = allLeaves(mesh);
  RandomVectors random(5);
  for (int i = 0; i < 100; ++i) {
    const Corners corners = triangleAround(0.2 * random.next(1.0).normalized(), 0.05, random);
    const HullGap gap = HullGapSearch(mesh, false, leaves, corners).search(random.next(1.0).normalized(), {1.0, 0.0});
    expectToBeMeasured(gap, mesh, corners);
    EXPECT_LT(gap.atLeast, 0.0);
  }
}

TEST(HullGap, isValidForSliversPointsAndSegments) {
  const SearchableMesh mesh = ball();
  const std::vector<std::int32_t> leaves = allLeaves(mesh);
  RandomVectors random(6);
  for (int i = 0; i < 60; ++i) {
    const Vec3 a = (0.31 + 0.001 * i) * random.next(1.0).normalized();
    const Vec3 along = random.next(1e-3);
    for (const Corners& corners :
         {Corners{a, a, a}, Corners{a, a + along, a}, Corners{a, a + along, a + 0.3 * along}}) {
      const double enough = 0.9 * distanceTo(mesh, corners);
      const HullGap gap = HullGapSearch(mesh, false, leaves, corners).search(a.normalized(), {1.0, enough});
      expectToBeMeasured(gap, mesh, corners);
      EXPECT_GE(gap.atLeast, enough);
    }
  }
}

TEST(HullGap, searchEndsWithPointsThatAreNotFinite) {
  const SearchableMesh mesh = ball();
  const std::vector<std::int32_t> leaves = allLeaves(mesh);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const Corners corners{Vec3(0.0, 0.31, 0.0), Vec3(0.01, 0.31, 0.0), Vec3(bad, 0.31, 0.01)};
    EXPECT_FALSE(HullGapSearch(mesh, false, leaves, corners).search(Vec3::UnitX(), {1.0, 0.1}).atLeast > 0.02);
    (void)HullGapSearch(mesh, false, leaves, corners).search(Vec3::Constant(bad), {1.0, 0.1});
  }
}

}  // namespace
}  // namespace drape::sim::contact
