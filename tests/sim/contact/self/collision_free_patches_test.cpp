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

namespace drape::sim::contact {
namespace {

using testing::lanesOf;
using testing::sheet;

/// A cloth with its patches.
struct PatchedCloth {
  ClothMesh mesh;
  CollisionFreePatches patches;

  explicit PatchedCloth(ClothMesh shape) : mesh(std::move(shape)) {
    const auto model = buildClothModel(mesh, 1.0, MassLumping::Uniform, {});
    PatchGrower().grow(patchMeshOf(*model), lanesOf(mesh.positions), patches);
  }

  std::vector<Triangle> trianglesOf(const CollisionFreePatch& patch) const {
    std::vector<Triangle> triangles;
    for (auto i = static_cast<std::size_t>(patch.firstCorner); i < static_cast<std::size_t>(patch.lastCorner); ++i) {
      const Triangle t = {patches.corners.a[i], patches.corners.b[i], patches.corners.c[i]};
      if (triangles.empty() || triangles.back() != t) {
        triangles.push_back(t);
      }
    }
    return triangles;
  }
};

/// A sheet with every vertex mapped by a function.
ClothMesh bent(int n, const std::function<Vec3(const Vec3&)>& shape) {
  ClothMesh mesh = sheet(n);
  std::transform(mesh.positions.begin(), mesh.positions.end(), mesh.positions.begin(), shape);
  return mesh;
}

/// The projected corners of a triangle, counter-clockwise.
using Flat = std::array<Vec2, 3>;

Flat seenAlong(const ClothMesh& mesh, const Triangle& triangle, const Vec3& axis) {
  const Vec3 u = axis.unitOrthogonal();
  const Vec3 w = axis.cross(u);
  Flat flat;
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3& position = mesh.positions[triangle[c]];
    flat[c] = Vec2(position.dot(u), position.dot(w));
  }
  return flat;
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Whether two triangles in the plane overlap by more than a sliver: no side of either separates them.
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

/// Checks that every patch faces its axis and covers no point of the plane twice, by comparing all of its triangles.
void expectCollisionFree(const PatchedCloth& cloth) {
  for (const CollisionFreePatch& patch : cloth.patches.patches) {
    const Vec3 axis(static_cast<double>(patch.axis[0]), static_cast<double>(patch.axis[1]),
                    static_cast<double>(patch.axis[2]));
    std::vector<Flat> flats;
    for (const Triangle& t : cloth.trianglesOf(patch)) {
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

/// Checks that every triangle and every vertex is in exactly one patch.
void expectPartition(const PatchedCloth& cloth) {
  std::multiset<Triangle> seen;
  for (const CollisionFreePatch& patch : cloth.patches.patches) {
    for (const Triangle& t : cloth.trianglesOf(patch)) {
      seen.insert(t);
    }
    EXPECT_EQ(patch.firstCorner % maxLanes, 0);
  }
  EXPECT_EQ(seen, std::multiset<Triangle>(cloth.mesh.triangles.begin(), cloth.mesh.triangles.end()));
  std::vector<int> vertices = cloth.patches.vertices;
  std::sort(vertices.begin(), vertices.end());
  for (std::size_t v = 0; v < cloth.mesh.positions.size(); ++v) {
    EXPECT_EQ(vertices[v], static_cast<int>(v));
    const CollisionFreePatch& patch = cloth.patches.patches[cloth.patches.patchOfVertex[v]];
    const auto first = cloth.patches.vertices.begin() + patch.firstVertex;
    const auto last = cloth.patches.vertices.begin() + patch.lastVertex;
    EXPECT_TRUE(std::binary_search(first, last, static_cast<int>(v)));
  }
}

Vec3 rolledUp(const Vec3& p, double turns) {
  const double angle = 2.0 * std::numbers::pi * turns * p.x();
  const double radius = 0.15 + 0.05 * p.x();
  return {radius * std::cos(angle), radius * std::sin(angle), p.z()};
}

/// A helical ramp: its normals vary little, but it lies above itself.
Vec3 ramp(const Vec3& p, double turns) {
  const double angle = -2.0 * std::numbers::pi * turns * p.x();
  const double radius = 0.5 + 0.5 * p.z();
  return {radius * std::cos(angle), 0.1 * turns * p.x(), radius * std::sin(angle)};
}

TEST(CollisionFreePatches, OneForAFlatSheet) {
  for (const int n : {2, 5, 17, 33}) {
    const PatchedCloth cloth(sheet(n));
    EXPECT_EQ(cloth.patches.count(), 1);
    EXPECT_EQ(cloth.patches.patches[0].lastBorder, 4 * (n - 1));
    expectPartition(cloth);
  }
}

TEST(CollisionFreePatches, OneForAGentlyWavingSheet) {
  const PatchedCloth cloth(
      bent(17, [](const Vec3& p) { return Vec3(p.x(), 0.05 * std::sin(9.0 * p.x() + 5.0 * p.z()), p.z()); }));
  EXPECT_EQ(cloth.patches.count(), 1);
  expectCollisionFree(cloth);
}

TEST(CollisionFreePatches, ARolledUpSheetIsDividedByItsNormals) {
  const PatchedCloth cloth(bent(25, [](const Vec3& p) { return rolledUp(p, 2.5); }));
  // Each patch spans at most 120 degrees of the roll.
  EXPECT_GE(cloth.patches.count(), 7);
  EXPECT_LE(cloth.patches.count(), 14);
  expectCollisionFree(cloth);
  expectPartition(cloth);
}

TEST(CollisionFreePatches, ARampIsDividedByItsBorderAlthoughItsNormalsAgree) {
  const PatchedCloth whole(bent(25, [](const Vec3& p) { return ramp(p, 0.9); }));
  EXPECT_EQ(whole.patches.count(), 1);
  const PatchedCloth cloth(bent(25, [](const Vec3& p) { return ramp(p, 2.5); }));
  EXPECT_GE(cloth.patches.count(), 3);
  EXPECT_LE(cloth.patches.count(), 8);
  expectCollisionFree(cloth);
  expectPartition(cloth);
}

TEST(CollisionFreePatches, AreCollisionFreeOnACrumpledSheet) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    testing::RandomVectors random(seed);
    ClothMesh mesh = sheet(13);
    for (Vec3& position : mesh.positions) {
      position += random.next(0.03 * (seed + 1));
    }
    const PatchedCloth cloth(std::move(mesh));
    EXPECT_GT(cloth.patches.count(), 1);
    expectCollisionFree(cloth);
    expectPartition(cloth);
  }
}

TEST(CollisionFreePatches, AreTheSameForTheSameShape) {
  const auto shape = [](const Vec3& p) { return rolledUp(p, 1.7); };
  EXPECT_EQ(PatchedCloth(bent(17, shape)).patches.patchOfVertex, PatchedCloth(bent(17, shape)).patches.patchOfVertex);
}

TEST(CollisionFreePatches, AClosedSurfaceNeedsAtLeastTwo) {
  // A tetrahedron.
  ClothMesh mesh;
  mesh.positions = {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  const PatchedCloth cloth(std::move(mesh));
  EXPECT_GE(cloth.patches.count(), 2);
  expectCollisionFree(cloth);
}

TEST(CollisionFreePatches, AcceptNonManifoldMeshes) {
  // Three triangles at one edge, one with the wrong orientation, one without area, and a vertex without triangles.
  ClothMesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                    Vec3(0, 0, 1), Vec3(2, 0, 0), Vec3(1, 1, 0), Vec3(9, 9, 9)};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 2, 6}, {0, 1, 5}};
  const PatchedCloth cloth(std::move(mesh));
  expectCollisionFree(cloth);
  EXPECT_EQ(cloth.patches.patchOfVertex.size(), 8u);
  EXPECT_EQ(cloth.patches.vertices.size(), 8u);
  const int loose = cloth.patches.patchOfVertex[7];
  EXPECT_EQ(std::count(cloth.patches.patchOfVertex.begin(), cloth.patches.patchOfVertex.end(), loose), 1);
}

bool isValid(const PatchedCloth& cloth, const ClothMesh& shape) {
  std::vector<char> valid;
  return PatchCheck().failures(cloth.patches, lanesOf(shape.positions), valid) == 0;
}

TEST(CollisionFreePatches, AreRepairedWhereTheyAreInvalid) {
  // A roll, one end of which is then crumpled.
  PatchedCloth cloth(bent(25, [](const Vec3& p) { return rolledUp(p, 1.5); }));
  const CollisionFreePatches before = cloth.patches;
  testing::RandomVectors random(5);
  for (std::size_t v = 0; v < cloth.mesh.positions.size(); ++v) {
    if (v % 25 < 6) {
      cloth.mesh.positions[v] += random.next(0.05);
    }
  }
  const auto model = buildClothModel(cloth.mesh, 1.0, MassLumping::Uniform, {});
  std::vector<char> valid;
  const int failed = PatchCheck().failures(before, lanesOf(cloth.mesh.positions), valid);
  EXPECT_GT(failed, 0);
  EXPECT_LT(failed, before.count());
  PatchGrower().repair(patchMeshOf(*model), lanesOf(cloth.mesh.positions), before, valid, cloth.patches);
  EXPECT_GT(cloth.patches.count(), before.count());
  EXPECT_TRUE(isValid(cloth, cloth.mesh));
  expectCollisionFree(cloth);
  expectPartition(cloth);
}

TEST(PatchCheck, SucceedsUntilTheClothBendsOutOfTheCone) {
  const auto bend = [](double degrees) {
    // A crease at x = 1/2; the axis is that of the flat sheet.
    const double angle = degrees * std::numbers::pi / 180.0;
    return bent(9, [=](const Vec3& p) {
      const double over = std::max(0.0, p.x() - 0.5);
      return Vec3(std::min(p.x(), 0.5) + over * std::cos(angle), over * std::sin(angle), p.z());
    });
  };
  const PatchedCloth cloth(sheet(9));
  EXPECT_TRUE(isValid(cloth, bend(0.0)));
  EXPECT_TRUE(isValid(cloth, bend(84.0)));
  EXPECT_FALSE(isValid(cloth, bend(86.0)));
  EXPECT_FALSE(isValid(cloth, bend(170.0)));
}

TEST(PatchCheck, SucceedsUntilABorderIntersectsItself) {
  const PatchedCloth cloth(bent(17, [](const Vec3& p) { return ramp(p, 0.9); }));
  ASSERT_EQ(cloth.patches.count(), 1);
  EXPECT_TRUE(isValid(cloth, bent(17, [](const Vec3& p) { return ramp(p, 0.98); })));
  EXPECT_FALSE(isValid(cloth, bent(17, [](const Vec3& p) { return ramp(p, 1.05); })));
}

TEST(BorderCheck, DetectsSimplePolygons) {
  const auto simple = [](const std::vector<Vec2>& corners) {
    std::vector<Vec3> positions;
    std::vector<int> border;
    for (const Vec2& corner : corners) {
      border.push_back(static_cast<int>(positions.size()));
      positions.emplace_back(corner.x(), corner.y(), 0.3 * static_cast<double>(positions.size()));
    }
    return BorderCheck().simple(border.data(), static_cast<int>(border.size()), lanesOf(positions), {0.0F, 0.0F, 1.0F});
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

TEST(BorderCheck, CountsSidesWithinTheMarginAsTouching) {
  // A U whose arms are 0.01 apart, at a corner and along sides.
  const std::vector<Vec3> positions = {{0, 0, 0},    {2.01, 0, 0}, {2.01, 3, 0}, {1.01, 3, 0},
                                       {1.01, 1, 0}, {1, 1, 0},    {1, 3, 0},    {0, 3, 0}};
  const std::vector<int> border = {0, 1, 2, 3, 4, 5, 6, 7};
  BorderCheck check;
  const auto simple = [&](float margin) {
    check.margin = margin;
    return check.simple(border.data(), static_cast<int>(border.size()), lanesOf(positions), {0.0F, 0.0F, 1.0F});
  };
  EXPECT_TRUE(simple(0.0F));
  EXPECT_TRUE(simple(0.001F));
  EXPECT_FALSE(simple(0.02F));
}

}  // namespace
}  // namespace drape::sim::contact
