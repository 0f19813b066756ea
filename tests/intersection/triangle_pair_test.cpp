#include "intersection/triangle_pair.hpp"

#include "convex_reference.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace drape::intersection::testing {
namespace {

using Vec3 = Eigen::Vector3d;

/// A map from integer points to doubles that preserves lines and planes exactly.
using Map = std::function<Vec3(const Eigen::Vector3i&)>;

Map plain() {
  return [](const Eigen::Vector3i& p) { return p.cast<double>(); };
}

/// A shear, so that all coordinates matter, and a translation far away, so that differences of products are rounded.
Map sheared(double scale) {
  return [scale](const Eigen::Vector3i& p) {
    Eigen::Matrix<double, 3, 3> shear;
    shear << 67108859, 1299709, 15485863, 32452843, 49979687, 7368787, 2750159, 86028121, 104729;
    return Vec3((shear * p.cast<double>() + Vec3(1e12, -3e12, 7e11)) * scale);
  };
}

Facet facetOf(const WholeTriangle& triangle, const Map& map) {
  return {map(triangle[0]), map(triangle[1]), map(triangle[2])};
}

const std::vector<Map>& maps() {
  static const std::vector<Map> all = {plain(), sheared(1.0), sheared(std::ldexp(1.0, -60))};
  return all;
}

/// All integer points of a box.
std::vector<Eigen::Vector3i> pointsOf(int nx, int ny, int nz) {
  std::vector<Eigen::Vector3i> points;
  for (int x = 0; x < nx; ++x) {
    for (int y = 0; y < ny; ++y) {
      for (int z = 0; z < nz; ++z) {
        points.emplace_back(x, y, z);
      }
    }
  }
  return points;
}

/// All triangles between points, equal corners included, each once.
std::vector<WholeTriangle> trianglesOf(const std::vector<Eigen::Vector3i>& points) {
  std::vector<WholeTriangle> triangles;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i; j < points.size(); ++j) {
      for (std::size_t k = j; k < points.size(); ++k) {
        triangles.push_back({points[i], points[j], points[k]});
      }
    }
  }
  return triangles;
}

/// Counts of both results, so that a test can check that both occurred.
struct Tally {
  int yes = 0;
  int no = 0;
  void add(bool met) { ++(met ? yes : no); }
};

void expectAllPairsAsReference(const std::vector<WholeTriangle>& triangles, Tally& tally) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = i; j < triangles.size(); ++j) {
      const bool expected = meetByDifferences(triangles[i], triangles[j]);
      tally.add(expected);
      for (const Map& map : maps()) {
        ASSERT_EQ(meet(facetOf(triangles[i], map), facetOf(triangles[j], map)), expected) << i << ' ' << j;
      }
    }
  }
}

TEST(TrianglePair, agreesWithTheReferenceOnAllPairsInACube) {
  Tally tally;
  expectAllPairsAsReference(trianglesOf(pointsOf(2, 2, 2)), tally);
  EXPECT_GT(tally.yes, 1000);
  EXPECT_GT(tally.no, 1000);
}

TEST(TrianglePair, agreesWithTheReferenceOnAllPairsInAPlane) {
  Tally tally;
  expectAllPairsAsReference(trianglesOf(pointsOf(3, 1, 3)), tally);
  EXPECT_GT(tally.yes, 1000);
  EXPECT_GT(tally.no, 1000);
}

class RandomTriangles {
 public:
  explicit RandomTriangles(int limit) : coordinate_(0, limit) {}
  Eigen::Vector3i point() { return {coordinate_(random_), coordinate_(random_), coordinate_(random_)}; }
  WholeTriangle triangle() { return {point(), point(), point()}; }
  WholeTriangle shuffled(WholeTriangle triangle) {
    std::shuffle(triangle.begin(), triangle.end(), random_);
    return triangle;
  }

 private:
  std::mt19937 random_{11};
  std::uniform_int_distribution<int> coordinate_;
};

TEST(TrianglePair, agreesWithTheReferenceOnRandomPairsInAnyOrder) {
  for (const int limit : {2, 4, 30}) {
    RandomTriangles random(limit);
    Tally tally;
    for (int i = 0; i < 1500; ++i) {
      const WholeTriangle a = random.triangle();
      const WholeTriangle b = random.triangle();
      const bool expected = meetByDifferences(a, b);
      tally.add(expected);
      for (const Map& map : maps()) {
        ASSERT_EQ(meet(facetOf(random.shuffled(a), map), facetOf(random.shuffled(b), map)), expected);
        ASSERT_EQ(meet(facetOf(random.shuffled(b), map), facetOf(random.shuffled(a), map)), expected);
      }
    }
    EXPECT_GT(tally.yes, 50);
    EXPECT_GT(tally.no, 50);
  }
}

TEST(TrianglePair, agreesWithTheReferenceWhereACornerIsShared) {
  for (const int limit : {1, 2, 5}) {
    RandomTriangles random(limit);
    Tally tally;
    for (int i = 0; i < 6000; ++i) {
      const WholeTriangle a = random.triangle();
      WholeTriangle b = random.triangle();
      b[0] = a[0];
      const bool expected = meetBeyondCornerByCones(a, b);
      tally.add(expected);
      for (const Map& map : maps()) {
        ASSERT_EQ(meetBeyondCorner(facetOf(a, map), facetOf(b, map)), expected) << i;
        ASSERT_EQ(meetBeyondCorner(facetOf({b[0], b[2], b[1]}, map), facetOf({a[0], a[2], a[1]}, map)), expected);
      }
    }
    EXPECT_GT(tally.yes, 500);
    EXPECT_GT(tally.no, 500);
  }
}

TEST(TrianglePair, agreesWithTheReferenceWhereAnEdgeIsShared) {
  for (const int limit : {1, 2, 4}) {
    RandomTriangles random(limit);
    Tally tally;
    for (int i = 0; i < 6000; ++i) {
      const WholeTriangle a = random.triangle();
      WholeTriangle b = random.triangle();
      b[0] = a[0];
      b[1] = a[1];
      const bool expected = meetBeyondEdgeByCones(a, b);
      tally.add(expected);
      for (const Map& map : maps()) {
        ASSERT_EQ(meetBeyondEdge(facetOf(a, map), facetOf(b, map)), expected) << i;
        ASSERT_EQ(meetBeyondEdge(facetOf({b[1], b[0], b[2]}, map), facetOf({a[1], a[0], a[2]}, map)), expected);
      }
    }
    EXPECT_GT(tally.yes, 100);
    EXPECT_GT(tally.no, 500);
  }
}

TEST(TrianglePair, dependsOnTheLastBit) {
  const Facet triangle({0.1, 0.2, 0.3}, {0.7, 0.9, 0.1}, {0.4, 0.3, 0.8});
  // A needle from above whose tip touches the corner, or ends one unit in the last place before it.
  const Vec3 tip(0.1, 0.2, 0.3);
  const Vec3 away(-1.0, -1.0, 1.0);
  const auto needle = [&](const Vec3& end) { return Facet(end, away, away + Vec3(0.0, 0.01, 0.0)); };
  EXPECT_TRUE(meet(triangle, needle(tip)));
  EXPECT_FALSE(meet(triangle, needle({std::nextafter(0.1, 0.0), 0.2, 0.3})));
}

TEST(TrianglePair, isTheSameAfterExactScalingAndExchangeForPointsThatRound) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::uniform_int_distribution<int> step(0, 4);
  Tally tally;
  for (int i = 0; i < 3000; ++i) {
    // The corners of both lie on few planes, but for rounding: weights of 0.1 are not exact.
    const Vec3 base(unit(random), unit(random), unit(random));
    const Vec3 along(unit(random), unit(random), unit(random));
    const Vec3 across(unit(random), unit(random), unit(random));
    const auto corner = [&] { return Vec3(base + 0.1 * step(random) * along + 0.1 * step(random) * across); };
    const std::array<Vec3, 6> p = {corner(), corner(), corner(), corner(), corner(), corner()};
    const bool met = meet(Facet(p[0], p[1], p[2]), Facet(p[3], p[4], p[5]));
    tally.add(met);
    EXPECT_EQ(meet(Facet(p[5], p[3], p[4]), Facet(p[1], p[0], p[2])), met);
    const double scale = std::ldexp(1.0, 40 - i % 80);
    const auto scaled = [&](int a, int b, int c) {
      const auto at = [&](int j) { return Vec3(p[static_cast<std::size_t>(j)] * scale); };
      return Facet(at(a), at(b), at(c));
    };
    EXPECT_EQ(meet(scaled(0, 2, 1), scaled(4, 3, 5)), met);
  }
  EXPECT_GT(tally.yes, 300);
  EXPECT_GT(tally.no, 300);
}

}  // namespace
}  // namespace drape::intersection::testing
