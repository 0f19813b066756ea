#include "sim/contact/closest_features/closest_points.hpp"

#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::sim::contact {
namespace {

using testing::RandomVectors;

/// Random triangles. Some have no area, coincident corners, or corners on a coarse lattice, so that features are
/// parallel, coplanar or touching.
Corners anyTriangle(RandomVectors& random, int kind) {
  Corners corners{random.next(1.0), random.next(1.0), random.next(1.0)};
  switch (kind % 6) {
    case 1:
      corners[2] = 0.3 * corners[0] + 0.7 * corners[1];
      break;
    case 2:
      corners[1] = corners[0];
      break;
    case 3:
      corners[2] = corners[1] = corners[0];
      break;
    case 4:
      for (Vec3& corner : corners) {
        corner = (2.0 * corner).array().round() / 2.0;
      }
      break;
    default:
      break;
  }
  return corners;
}

bool areWeights(const Vec3& weights) {
  return (weights.array() >= 0.0).all() && std::abs(weights.sum() - 1.0) < 1e-12;
}

/// Optimality condition for convex sets: a point x of a triangle is closest to p if and only if (c - x).(p - x) <= 0
/// for all corners c.
void expectNearest(const Vec3& point, const Corners& triangle, const Vec3& weights) {
  const Vec3 nearest = pointAt(triangle, weights);
  for (const Vec3& corner : triangle) {
    EXPECT_LE((corner - nearest).dot(point - nearest), 1e-9);
  }
}

TEST(ClosestPoints, nearestOnTriangleMeetsTheOptimalityConditionForAnyTriangle) {
  RandomVectors random(1);
  for (int i = 0; i < 3000; ++i) {
    const Corners triangle = anyTriangle(random, i);
    const Vec3 point = i % 7 == 0 ? triangle[0] : random.next(2.0);
    const Vec3 weights = nearestOnTriangle(point, triangle);
    ASSERT_TRUE(areWeights(weights));
    expectNearest(point, triangle, weights);
  }
}

TEST(ClosestPoints, nearestOfSegmentsMeetsTheOptimalityConditionForAnyPair) {
  RandomVectors random(2);
  for (int i = 0; i < 3000; ++i) {
    const Corners a = anyTriangle(random, i);
    const Corners b = anyTriangle(random, i / 6);
    std::array<Vec3, 2> first{a[0], a[1]};
    std::array<Vec3, 2> second{b[0], b[1]};
    if (i % 11 == 0) {
      second = {first[0] + Vec3(0, 1, 0), first[1] + Vec3(0, 1, 0)};
    }
    const SegmentPair pair = nearestOfSegments(first, second);
    const Vec3 p = first[0] + pair.first * (first[1] - first[0]);
    const Vec3 q = second[0] + pair.second * (second[1] - second[0]);
    for (const Vec3& end : first) {
      EXPECT_LE((end - p).dot(q - p), 1e-7);
    }
    for (const Vec3& end : second) {
      EXPECT_LE((end - q).dot(p - q), 1e-7);
    }
  }
}

/// The distance of two triangles by sampling: the minimum over many points of the first of the exact distance to the
/// second.
double sampledDistance(const Corners& first, const Corners& second) {
  constexpr int n = 40;
  double minimum = 1e9;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      const Vec3 point = pointAt(first, Vec3(n - i - j, i, j) / n);
      minimum = std::min(minimum, (pointAt(second, nearestOnTriangle(point, second)) - point).norm());
    }
  }
  return minimum;
}

TEST(ClosestPoints, gapOfTrianglesIsTheirDistanceAndHasASeparatingPlane) {
  RandomVectors random(3);
  int apart = 0;
  int intersecting = 0;
  for (int i = 0; i < 1200; ++i) {
    const Corners first = anyTriangle(random, i);
    Corners second = anyTriangle(random, i / 6);
    const Vec3 shift = random.next(1.0);
    for (Vec3& corner : second) {
      corner += shift;
    }
    const TriangleGap gap = gapOfTriangles(first, second);
    const double sampled = sampledDistance(first, second);
    if (gap.distance > 0.0) {
      ++apart;
      EXPECT_NEAR(gap.normal.norm(), 1.0, 1e-12);
      for (const Vec3& a : first) {
        for (const Vec3& b : second) {
          EXPECT_GE(gap.normal.dot(a - b), gap.distance - 1e-9);
        }
      }
      EXPECT_LE(gap.distance, sampled + 1e-9);
      EXPECT_GE(gap.distance, sampled - 0.08);  // error of the sampling
      EXPECT_NEAR((pointAt(first, gap.firstWeights) - pointAt(second, gap.secondWeights)).norm(), gap.distance, 1e-9);
    } else {
      ++intersecting;
      EXPECT_LT(sampled, 0.08);
    }
  }
  EXPECT_GT(apart, 600);
  EXPECT_GE(intersecting, 50);
}

TEST(ClosestPoints, nearestOfTriangleAndSegmentAgreesWithSampling) {
  RandomVectors random(4);
  for (int i = 0; i < 600; ++i) {
    const Corners triangle = anyTriangle(random, i);
    const Corners other = anyTriangle(random, i / 6);
    const std::array<Vec3, 2> segment{other[0], other[1]};
    const TriangleSegmentPair pair = nearestOfTriangleAndSegment(triangle, segment);
    ASSERT_TRUE(areWeights(pair.weights));
    const Vec3 p = pointAt(triangle, pair.weights);
    const Vec3 q = segment[0] + pair.along * (segment[1] - segment[0]);
    const double distance = (p - q).norm();
    for (int s = 0; s <= 50; ++s) {
      const Vec3 sample = segment[0] + 0.02 * s * (segment[1] - segment[0]);
      EXPECT_GE((pointAt(triangle, nearestOnTriangle(sample, triangle)) - sample).norm(), distance - 1e-9);
    }
  }
}

}  // namespace
}  // namespace drape::sim::contact
