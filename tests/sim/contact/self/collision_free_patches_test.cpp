#include "sim/contact/self/collision_free_patches.hpp"

#include "contact/self/position_lanes.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <vector>

namespace drape {
namespace {

using testing::lanesOf;
using testing::sheet;

/// A cloth in some shape with its charts.
struct Charted {
  ClothMesh mesh;
  SelfCharts charts;

  explicit Charted(ClothMesh shape) : mesh(std::move(shape)) {
    const auto model = buildClothModel(mesh, 1.0, MassLumping::Uniform, {});
    ChartGrower().grow(chartMeshOf(*model), lanesOf(mesh.positions), charts);
  }

  std::vector<Triangle> trianglesOf(const CollisionFreeChart& chart) const {
    std::vector<Triangle> triangles;
    for (auto i = static_cast<std::size_t>(chart.firstCorner); i < static_cast<std::size_t>(chart.lastCorner); ++i) {
      const Triangle t = {charts.corners.a[i], charts.corners.b[i], charts.corners.c[i]};
      if (triangles.empty() || triangles.back() != t) {
        triangles.push_back(t);
      }
    }
    return triangles;
  }
};

/// The sheet with every vertex moved by a function of its place.
ClothMesh bent(int n, const std::function<Vec3(const Vec3&)>& shape) {
  ClothMesh mesh = sheet(n);
  std::transform(mesh.positions.begin(), mesh.positions.end(), mesh.positions.begin(), shape);
  return mesh;
}

/// Corners of a triangle seen along a direction, counter-clockwise.
using Flat = std::array<Vec2, 3>;

Flat seenAlong(const ClothMesh& mesh, const Triangle& triangle, const Vec3& axis) {
  const Vec3 u = axis.unitOrthogonal();
  const Vec3 w = axis.cross(u);
  Flat flat;
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3& place = mesh.positions[static_cast<std::size_t>(triangle[c])];
    flat[c] = Vec2(place.dot(u), place.dot(w));
  }
  return flat;
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// True when two triangles in the plane have more than a sliver in common: no side of either parts them.
bool overlap(const Flat& a, const Flat& b) {
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec2& from = (*one)[c];
      const Vec2& to = (*one)[(c + 1) % 3];
      const double slack = 1e-6 * (to - from).norm();
      if (std::all_of(other->begin(), other->end(), [&](const Vec2& p) { return turn(from, to, p) <= slack * 0.05; })) {
        return false;
      }
    }
  }
  return true;
}

/// Every chart faces its axis and covers no point of the plane twice, by comparing all of its triangles.
void expectCollisionFree(const Charted& cloth) {
  for (const CollisionFreeChart& chart : cloth.charts.charts) {
    const Vec3 axis(static_cast<double>(chart.axis[0]), static_cast<double>(chart.axis[1]),
                    static_cast<double>(chart.axis[2]));
    std::vector<Flat> flats;
    for (const Triangle& t : cloth.trianglesOf(chart)) {
      flats.push_back(seenAlong(cloth.mesh, t, axis));
      EXPECT_GT(turn(flats.back()[0], flats.back()[1], flats.back()[2]), 0.0);
    }
    int overlaps = 0;
    for (std::size_t i = 0; i < flats.size(); ++i) {
      for (std::size_t j = i + 1; j < flats.size(); ++j) {
        overlaps += overlap(flats[i], flats[j]) ? 1 : 0;
      }
    }
    EXPECT_EQ(overlaps, 0);
  }
}

/// Every triangle in one chart, every vertex in one chart, each border a circle.
void expectPartition(const Charted& cloth) {
  std::multiset<Triangle> seen;
  for (const CollisionFreeChart& chart : cloth.charts.charts) {
    for (const Triangle& t : cloth.trianglesOf(chart)) {
      seen.insert(t);
    }
    EXPECT_EQ(chart.firstCorner % mostLanes, 0);
  }
  EXPECT_EQ(seen, std::multiset<Triangle>(cloth.mesh.triangles.begin(), cloth.mesh.triangles.end()));
  std::vector<int> vertices = cloth.charts.vertices;
  std::sort(vertices.begin(), vertices.end());
  for (std::size_t v = 0; v < cloth.mesh.positions.size(); ++v) {
    EXPECT_EQ(vertices[v], static_cast<int>(v));
    const CollisionFreeChart& chart = cloth.charts.charts[static_cast<std::size_t>(cloth.charts.chartOfVertex[v])];
    const auto first = cloth.charts.vertices.begin() + chart.firstVertex;
    const auto last = cloth.charts.vertices.begin() + chart.lastVertex;
    EXPECT_TRUE(std::binary_search(first, last, static_cast<int>(v)));
  }
}

Vec3 rolledUp(const Vec3& p, double turns) {
  const double angle = 2.0 * std::numbers::pi * turns * p.x();
  const double radius = 0.15 + 0.05 * p.x();
  return {radius * std::cos(angle), radius * std::sin(angle), p.z()};
}

/// A ramp that climbs around an axis: its normals hardly lean, yet it lies above itself.
Vec3 ramp(const Vec3& p, double turns) {
  const double angle = -2.0 * std::numbers::pi * turns * p.x();
  const double radius = 0.5 + 0.5 * p.z();
  return {radius * std::cos(angle), 0.1 * turns * p.x(), radius * std::sin(angle)};
}

TEST(SelfCharts, AFlatSheetIsOne) {
  for (const int n : {2, 5, 17, 33}) {
    const Charted cloth(sheet(n));
    EXPECT_EQ(cloth.charts.count(), 1);
    EXPECT_EQ(cloth.charts.charts[0].lastBorder, 4 * (n - 1));
    expectPartition(cloth);
  }
}

TEST(SelfCharts, AGentlyWavingSheetIsOne) {
  const Charted cloth(
      bent(17, [](const Vec3& p) { return Vec3(p.x(), 0.05 * std::sin(9.0 * p.x() + 5.0 * p.z()), p.z()); }));
  EXPECT_EQ(cloth.charts.count(), 1);
  expectCollisionFree(cloth);
}

TEST(SelfCharts, ARolledUpSheetIsCutByItsNormals) {
  const Charted cloth(bent(25, [](const Vec3& p) { return rolledUp(p, 2.5); }));
  // Each chart spans 120 degrees of the roll at most.
  EXPECT_GE(cloth.charts.count(), 7);
  EXPECT_LE(cloth.charts.count(), 14);
  expectCollisionFree(cloth);
  expectPartition(cloth);
}

TEST(SelfCharts, ARampIsCutByItsBorderAlthoughAllItsNormalsAgree) {
  const Charted whole(bent(25, [](const Vec3& p) { return ramp(p, 0.9); }));
  EXPECT_EQ(whole.charts.count(), 1);
  const Charted cloth(bent(25, [](const Vec3& p) { return ramp(p, 2.5); }));
  EXPECT_GE(cloth.charts.count(), 3);
  EXPECT_LE(cloth.charts.count(), 8);
  expectCollisionFree(cloth);
  expectPartition(cloth);
}

TEST(SelfCharts, ACrumpledSheetIsCollisionFreeInEachOfThem) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    testing::RandomVectors random(seed);
    ClothMesh mesh = sheet(13);
    for (Vec3& position : mesh.positions) {
      position += random.next(0.03 * (seed + 1));
    }
    const Charted cloth(std::move(mesh));
    EXPECT_GT(cloth.charts.count(), 1);
    expectCollisionFree(cloth);
    expectPartition(cloth);
  }
}

TEST(SelfCharts, AreTheSameForTheSameShape) {
  const auto shape = [](const Vec3& p) { return rolledUp(p, 1.7); };
  EXPECT_EQ(Charted(bent(17, shape)).charts.chartOfVertex, Charted(bent(17, shape)).charts.chartOfVertex);
}

TEST(SelfCharts, AClosedSurfaceNeedsAtLeastTwo) {
  // A tetrahedron.
  ClothMesh mesh;
  mesh.positions = {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  const Charted cloth(std::move(mesh));
  EXPECT_GE(cloth.charts.count(), 2);
  expectCollisionFree(cloth);
}

TEST(SelfCharts, TakeMeshesThatAreNoSurface) {
  // Three triangles at one edge, one run through the wrong way round, one without area, and a vertex that none has.
  ClothMesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                    Vec3(0, 0, 1), Vec3(2, 0, 0), Vec3(1, 1, 0), Vec3(9, 9, 9)};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 2, 6}, {0, 1, 5}};
  const Charted cloth(std::move(mesh));
  expectCollisionFree(cloth);
  EXPECT_EQ(cloth.charts.chartOfVertex.size(), 8u);
  EXPECT_EQ(cloth.charts.vertices.size(), 8u);
  const int loose = cloth.charts.chartOfVertex[7];
  EXPECT_EQ(std::count(cloth.charts.chartOfVertex.begin(), cloth.charts.chartOfVertex.end(), loose), 1);
}

bool hold(const Charted& cloth, const ClothMesh& shape) {
  std::vector<char> holds;
  return ChartCheck().failures(cloth.charts, lanesOf(shape.positions), holds) == 0;
}

TEST(SelfCharts, AreMendedWhereTheyHoldNoLonger) {
  // A roll; then one end of it is crumpled.
  Charted cloth(bent(25, [](const Vec3& p) { return rolledUp(p, 1.5); }));
  const SelfCharts before = cloth.charts;
  testing::RandomVectors random(5);
  for (std::size_t v = 0; v < cloth.mesh.positions.size(); ++v) {
    if (v % 25 < 6) {
      cloth.mesh.positions[v] += random.next(0.05);
    }
  }
  const auto model = buildClothModel(cloth.mesh, 1.0, MassLumping::Uniform, {});
  std::vector<char> holds;
  const int failed = ChartCheck().failures(before, lanesOf(cloth.mesh.positions), holds);
  EXPECT_GT(failed, 0);
  EXPECT_LT(failed, before.count());
  ChartGrower().mend(chartMeshOf(*model), lanesOf(cloth.mesh.positions), before, holds, cloth.charts);
  EXPECT_GT(cloth.charts.count(), before.count());
  EXPECT_TRUE(hold(cloth, cloth.mesh));
  expectCollisionFree(cloth);
  expectPartition(cloth);
}

TEST(ChartCheck, HoldsUntilTheClothBendsOutOfTheCone) {
  const auto bend = [](double degrees) {
    // A crease at x = 1/2; the axis is that of the flat sheet.
    const double angle = degrees * std::numbers::pi / 180.0;
    return bent(9, [=](const Vec3& p) {
      const double over = std::max(0.0, p.x() - 0.5);
      return Vec3(std::min(p.x(), 0.5) + over * std::cos(angle), over * std::sin(angle), p.z());
    });
  };
  const Charted cloth(sheet(9));
  EXPECT_TRUE(hold(cloth, bend(0.0)));
  EXPECT_TRUE(hold(cloth, bend(84.0)));
  EXPECT_FALSE(hold(cloth, bend(86.0)));
  EXPECT_FALSE(hold(cloth, bend(170.0)));
}

TEST(ChartCheck, HoldsUntilABorderCrossesItself) {
  const Charted cloth(bent(17, [](const Vec3& p) { return ramp(p, 0.9); }));
  ASSERT_EQ(cloth.charts.count(), 1);
  EXPECT_TRUE(hold(cloth, bent(17, [](const Vec3& p) { return ramp(p, 0.98); })));
  EXPECT_FALSE(hold(cloth, bent(17, [](const Vec3& p) { return ramp(p, 1.05); })));
}

TEST(BorderCheck, TellsSimplePolygonsFromOthers) {
  const auto simple = [](const std::vector<Vec2>& corners) {
    std::vector<Vec3> places;
    std::vector<int> border;
    for (const Vec2& corner : corners) {
      border.push_back(static_cast<int>(places.size()));
      places.emplace_back(corner.x(), corner.y(), 0.3 * static_cast<double>(places.size()));
    }
    return BorderCheck().simple(border.data(), static_cast<int>(border.size()), lanesOf(places), {0.0F, 0.0F, 1.0F});
  };
  EXPECT_TRUE(simple({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_FALSE(simple({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));                                 // a bow tie
  EXPECT_TRUE(simple({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}));  // a U
  EXPECT_FALSE(simple({{0, 0}, {3, 0}, {3, 3}, {0.5, 3}, {0.5, 1}, {1, 1}, {1, 2}, {0, 2}}));
  EXPECT_FALSE(simple({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));  // a corner on a side
  std::vector<Vec2> star;
  for (int i = 0; i < 60; ++i) {
    const double radius = i % 2 == 0 ? 1.0 : 0.4;
    star.emplace_back(radius * std::cos(0.1047 * i), radius * std::sin(0.1047 * i));
  }
  EXPECT_TRUE(simple(star));
  std::swap(star[20], star[50]);
  EXPECT_FALSE(simple(star));
}

}  // namespace
}  // namespace drape
