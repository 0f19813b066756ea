#include "intersection/intersections.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace drape::intersection::testing {
namespace {

using Vec3 = Eigen::Vector3d;
using Pairs = std::vector<TrianglePair>;

struct Mesh {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> triangles;
  [[nodiscard]] Surface surface() const { return {positions, triangles}; }
};

/// Rows x columns cells in the plane z = 0, two triangles each.
Mesh sheet(int cells) {
  Mesh mesh;
  for (int r = 0; r <= cells; ++r) {
    for (int c = 0; c <= cells; ++c) {
      mesh.positions.emplace_back(0.1 * c, 0.1 * r, 0.0);
    }
  }
  for (int r = 0; r < cells; ++r) {
    for (int c = 0; c < cells; ++c) {
      const int i = r * (cells + 1) + c;
      mesh.triangles.push_back({i, i + 1, i + cells + 2});
      mesh.triangles.push_back({i, i + cells + 2, i + cells + 1});
    }
  }
  return mesh;
}

/// Two triangles (0, 1, 2) and the one with the given indices.
Mesh pairWith(std::array<int, 3> second, std::vector<Vec3> more) {
  Mesh mesh{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}, second}};
  mesh.positions.insert(mesh.positions.end(), more.begin(), more.end());
  return mesh;
}

int countOf(const Mesh& mesh) {
  return static_cast<int>(intersectingPairs(mesh.surface()).size());
}

TEST(Intersections, matchCountsByHandWithoutSharedVertices) {
  EXPECT_EQ(countOf(pairWith({3, 4, 5}, {{1, 1, -1}, {1, 1, 1}, {5, 5, 1}})), 1);   // pierced
  EXPECT_EQ(countOf(pairWith({3, 4, 5}, {{1, 1, 0}, {1, 1, 1}, {5, 5, 1}})), 1);    // touched by a corner
  EXPECT_EQ(countOf(pairWith({3, 4, 5}, {{2, 2, -1}, {2, 2, 1}, {5, 5, 1}})), 1);   // edge on edge
  EXPECT_EQ(countOf(pairWith({3, 4, 5}, {{0, 0, 0}, {-1, 0, 1}, {0, -1, 1}})), 1);  // corner on corner
  EXPECT_EQ(countOf(pairWith({3, 4, 5}, {{1, 1, 1e-300}, {1, 1, 1}, {5, 5, 1}})), 0);
  EXPECT_EQ(countOf(pairWith({3, 4, 5}, {{3, 3, -1}, {3, 3, 1}, {5, 5, 1}})), 0);  // passes by
  EXPECT_EQ(countOf(pairWith({3, 4, 5}, {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}})), 1);   // inside, in the same plane
  EXPECT_EQ(countOf(pairWith({3, 4, 5}, {{3, 3, 0}, {4, 3, 0}, {3, 4, 0}})), 0);   // beside it, in the same plane
  EXPECT_EQ(countOf(pairWith({3, 4, 5}, {{2, 2, 0}, {4, 3, 0}, {3, 4, 0}})), 1);   // touching, in the same plane
}

TEST(Intersections, matchCountsByHandWithOneSharedVertex) {
  EXPECT_EQ(countOf(pairWith({0, 3, 4}, {{-1, 0, 1}, {0, -1, 1}})), 0);
  EXPECT_EQ(countOf(pairWith({0, 3, 4}, {{1, 1, -1}, {1, 1, 1}})), 1);  // pierced along a line from the corner
  EXPECT_EQ(countOf(pairWith({0, 3, 4}, {{-1, -1, -1}, {-1, -1, 1}})), 0);
  EXPECT_EQ(countOf(pairWith({0, 3, 4}, {{-4, 0, 0}, {0, -4, 0}})), 0);  // opposite, in the same plane
  EXPECT_EQ(countOf(pairWith({0, 3, 4}, {{2, 0, 0}, {0, -4, 0}})), 1);   // along a part of an edge
  EXPECT_EQ(countOf(pairWith({0, 3, 4}, {{2, -1, 0}, {0, -4, 0}})), 0);
  EXPECT_EQ(countOf(pairWith({0, 3, 4}, {{0, 0, 0}, {-1, 0, 1}})), 0);  // a segment that only starts there
  EXPECT_EQ(countOf(pairWith({0, 3, 4}, {{0, 0, 0}, {1, 1, 0}})), 1);   // a segment that lies in the triangle
  EXPECT_EQ(countOf(pairWith({0, 3, 4}, {{0, 0, 0}, {0, 0, 0}})), 0);   // no more than the corner itself
}

TEST(Intersections, matchCountsByHandWithASharedEdge) {
  EXPECT_EQ(countOf(pairWith({1, 0, 3}, {{1, -1, 0}})), 0);  // flat, side by side
  EXPECT_EQ(countOf(pairWith({1, 0, 3}, {{1, 1, 1}})), 0);   // bent
  EXPECT_EQ(countOf(pairWith({1, 0, 3}, {{1, 1, 1e-300}})), 0);
  EXPECT_EQ(countOf(pairWith({1, 0, 3}, {{1, 1, 0}})), 1);  // folded over
  EXPECT_EQ(countOf(pairWith({1, 0, 3}, {{9, 9, 0}})), 1);
  EXPECT_EQ(countOf(pairWith({1, 0, 3}, {{2, 0, 0}})), 0);  // no more than the edge
  EXPECT_EQ(countOf(pairWith({1, 2, 0}, {})), 1);           // the same triangle
}

TEST(Intersections, ofAFlatSheetAreNone) {
  Mesh mesh = sheet(12);
  EXPECT_EQ(countOf(mesh), 0);
  for (Vec3& p : mesh.positions) {
    p = Vec3(0.3 * p[0] - 0.1 * p[1] + 1.7, 0.7 * p[1] + 0.2 * p[0], p[2] + std::sin(4.0 * p[0]));
  }
  EXPECT_EQ(countOf(mesh), 0);
}

TEST(Intersections, ofASheetThatIsFoldedInItsPlaneAreThoseOfItsLayers) {
  Mesh mesh = sheet(4);
  for (Vec3& p : mesh.positions) {
    p[0] = 0.2 - std::abs(p[0] - 0.2);
  }
  const Pairs pairs = intersectingPairs(mesh.surface());
  const auto contains = [&](int i, int j) {
    return std::find(pairs.begin(), pairs.end(), TrianglePair{std::min(i, j), std::max(i, j)}) != pairs.end();
  };
  for (int row = 0; row < 4; ++row) {
    EXPECT_TRUE(contains(8 * row, 8 * row + 6));      // the outermost cells
    EXPECT_TRUE(contains(8 * row + 3, 8 * row + 4));  // the two at the fold: they share its edge
    EXPECT_FALSE(contains(8 * row, 8 * row + 1));
  }
}

/// Random vertices, so that many triangles intersect.
Mesh crumpled(int cells, unsigned seed) {
  Mesh mesh = sheet(cells);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.15, 0.15);
  for (Vec3& p : mesh.positions) {
    p += Vec3(shift(random), shift(random), shift(random));
  }
  return mesh;
}

/// Tests every pair of triangles without a search structure.
Pairs withoutSearch(const Mesh& mesh) {
  Pairs pairs;
  const int count = static_cast<int>(mesh.triangles.size());
  for (int i = 0; i < count; ++i) {
    for (int j = i + 1; j < count; ++j) {
      const std::vector<std::array<int, 3>> two = {mesh.triangles[static_cast<std::size_t>(i)],
                                                   mesh.triangles[static_cast<std::size_t>(j)]};
      if (!intersectingPairs(Surface{mesh.positions, two}).empty()) {
        pairs.push_back({i, j});
      }
    }
  }
  return pairs;
}

TEST(Intersections, areTheSameWithAndWithoutASearchStructure) {
  const Mesh mesh = crumpled(6, 5);
  const Pairs pairs = intersectingPairs(mesh.surface());
  EXPECT_GT(pairs.size(), 100U);
  EXPECT_LT(pairs.size(), 72U * 71U / 4U);
  EXPECT_EQ(pairs, withoutSearch(mesh));
}

TEST(Intersections, doNotDependOnTheOrderOfTrianglesVerticesAndCorners) {
  Mesh mesh = crumpled(8, 6);
  const std::size_t expected = intersectingPairs(mesh.surface()).size();
  std::mt19937 random(1);
  for (auto& triangle : mesh.triangles) {
    std::shuffle(triangle.begin(), triangle.end(), random);
  }
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  EXPECT_EQ(intersectingPairs(mesh.surface()).size(), expected);
}

TEST(Intersections, doNotChangeWithExactMotionsOfTheWhole) {
  Mesh mesh = crumpled(8, 7);
  for (Vec3& p : mesh.positions) {
    p = (p * 1024.0).array().round() / 1024.0;  // leaves bits for the sums
  }
  const Pairs expected = intersectingPairs(mesh.surface());
  Mesh moved = mesh;
  for (Vec3& p : moved.positions) {
    p = Vec3(p[2] + 3.0, -p[0] + 512.0, p[1] - 77.5) * 0.0625;
  }
  EXPECT_EQ(intersectingPairs(moved.surface()), expected);
}

TEST(Intersections, betweenTwoSurfacesAreThoseOfEachTriangleWithEachOther) {
  const Mesh cloth = crumpled(5, 8);
  Mesh body = sheet(3);
  for (Vec3& p : body.positions) {
    p = Vec3(2.0 * p[0] - 0.05, p[2] + 0.25, 2.0 * p[1] - 0.3);
  }
  Pairs expected;
  for (std::size_t i = 0; i < cloth.triangles.size(); ++i) {
    for (std::size_t j = 0; j < body.triangles.size(); ++j) {
      const Surface a{cloth.positions, std::span(cloth.triangles).subspan(i, 1)};
      const Surface b{body.positions, std::span(body.triangles).subspan(j, 1)};
      if (!intersectingPairs(a, b).empty()) {
        expected.push_back({static_cast<int>(i), static_cast<int>(j)});
      }
    }
  }
  EXPECT_GT(expected.size(), 10U);
  EXPECT_EQ(intersectingPairs(cloth.surface(), body.surface()), expected);
}

TEST(Intersections, withAPlaneAreTheTrianglesThatTouchItOrAreBehindIt) {
  const Mesh mesh{{{0, 0, 0}, {1, 1, 0}, {0, 1, 1}, {1, 2, 1}, {0, -1, 0}, {1, -1, 0}, {1, -3, 1}, {0, 1e-300, 0}},
                  {{0, 1, 2}, {1, 2, 3}, {1, 2, 4}, {4, 5, 6}, {7, 1, 2}}};
  const std::array<Vec3, 3> ground = {Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(1, 0, 0)};
  EXPECT_EQ(trianglesReaching(mesh.surface(), ground), (std::vector<int>{0, 2, 3}));
  const std::array<Vec3, 3> ceiling = {ground[0], ground[2], ground[1]};
  EXPECT_EQ(trianglesReaching(mesh.surface(), ceiling), (std::vector<int>{0, 1, 2, 4}));
}

TEST(Intersections, ofNothingAreNone) {
  const Mesh nothing;
  EXPECT_TRUE(intersectingPairs(nothing.surface()).empty());
  EXPECT_TRUE(intersectingPairs(nothing.surface(), sheet(1).surface()).empty());
  EXPECT_TRUE(intersectingPairs(sheet(1).surface(), nothing.surface()).empty());
}

TEST(Intersections, requireAValidSurface) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity}) {
    Mesh mesh = sheet(1);
    mesh.positions[2][1] = bad;
    EXPECT_THROW((void)intersectingPairs(mesh.surface()), std::invalid_argument);
  }
  for (const int bad : {-1, 4, 0}) {
    Mesh mesh = sheet(1);
    mesh.triangles[1] = {0, bad, 3};
    EXPECT_THROW((void)intersectingPairs(mesh.surface()), std::invalid_argument);
  }
}

}  // namespace
}  // namespace drape::intersection::testing
