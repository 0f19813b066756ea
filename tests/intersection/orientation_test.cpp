#include "intersection/orientation.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <random>

namespace drape::intersection::testing {
namespace {

using Vec3 = Eigen::Vector3d;
__extension__ typedef __int128 Whole;  // NOLINT(modernize-use-using)

int signOf(Whole value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// The same sign with 128-bit integers: exact for integer coordinates below 2^39.
int wholeVolumeSign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto part = [](const Vec3& p, const Vec3& q, int axis) { return static_cast<Whole>(p[axis] - q[axis]); };
  Whole sum = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    sum += part(b, a, i) * (part(c, a, j) * part(d, a, k) - part(c, a, k) * part(d, a, j));
  }
  return signOf(sum);
}

int wholeAreaSign(const Vec3& a, const Vec3& b, const Vec3& c) {
  return signOf(static_cast<Whole>(b[0] - a[0]) * static_cast<Whole>(c[1] - a[1]) -
                static_cast<Whole>(b[1] - a[1]) * static_cast<Whole>(c[0] - a[0]));
}

/// The sign in plain floating point.
int roundedVolumeSign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double volume = (b - a).dot((c - a).cross(d - a));
  return volume > 0.0 ? 1 : volume < 0.0 ? -1 : 0;
}

class WholePoints {
 public:
  explicit WholePoints(double limit) : coordinate_(-limit, limit) {}
  Vec3 operator()() { return {next(), next(), next()}; }
  double next() { return std::round(coordinate_(random_)); }

 private:
  std::mt19937_64 random_{7};
  std::uniform_real_distribution<double> coordinate_;
};

TEST(Orientation, isPositiveOnTheSideFromWhichATriangleTurnsCounterClockwise) {
  const Vec3 a(0, 0, 0);
  const Vec3 b(1, 0, 0);
  const Vec3 c(0, 1, 0);
  EXPECT_EQ(orientation(a, b, c, Vec3(0, 0, 1)), 1);
  EXPECT_EQ(orientation(a, b, c, Vec3(0, 0, -1)), -1);
  EXPECT_EQ(orientation(a, b, c, Vec3(7, -3, 0)), 0);
  EXPECT_EQ(orientation(a, b, c, Projection{0, 1}), 1);
  EXPECT_EQ(orientation(a, c, b, Projection{0, 1}), -1);
  EXPECT_EQ(orientation(a, b, Vec3(5, 0, 9), Projection{0, 1}), 0);
}

TEST(Orientation, isRightForPointsNearlyInAPlaneWherePlainArithmeticIsWrong) {
  WholePoints points(std::ldexp(1.0, 38));
  WholePoints weights(8.0);
  int wrong = 0;
  int inPlane = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = points();
    const Vec3 b = points();
    const Vec3 c = points();
    // Near the plane by at most one unit in 2^38, or in it.
    Vec3 d = ((a + b + c) / 3.0).array().round() + weights()[0] / 8.0;
    d = d.array().round();
    const int sign = wholeVolumeSign(a, b, c, d);
    ASSERT_EQ(orientation(a, b, c, d), sign);
    wrong += roundedVolumeSign(a, b, c, d) != sign ? 1 : 0;
    const Vec3 corner = b + c - a;  // closes a parallelogram
    ASSERT_EQ(orientation(a, b, c, corner), 0);
    inPlane += roundedVolumeSign(a, b, c, corner) != 0 ? 1 : 0;
  }
  EXPECT_GT(inPlane, 1000);
  EXPECT_GT(wrong + inPlane, 1000);
}

TEST(Orientation, isRightForPointsNearlyOnALine) {
  WholePoints points(std::ldexp(1.0, 52));
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = points();
    const Vec3 b = points();
    const Vec3 middle = ((a + b) / 2.0).array().round();
    for (const double shift : {-1.0, 0.0, 1.0}) {
      const Vec3 c = middle + Vec3(0, shift, 0);
      ASSERT_EQ(orientation(a, b, c, Projection{0, 1}), wholeAreaSign(a, b, c));
    }
  }
}

TEST(Orientation, changesSignWithEveryExchangeOfTwoPoints) {
  WholePoints points(1000.0);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = points() * 0.1;
    const Vec3 b = points() * 0.1;
    const Vec3 c = points() * 0.1;
    const Vec3 d = (a + b + c) / 3.0;  // rounded, so nearly in the plane
    const int sign = orientation(a, b, c, d);
    EXPECT_EQ(orientation(b, a, c, d), -sign);
    EXPECT_EQ(orientation(a, c, b, d), -sign);
    EXPECT_EQ(orientation(a, b, d, c), -sign);
    EXPECT_EQ(orientation(d, a, b, c), -sign);
    EXPECT_EQ(orientation(b, c, a, Projection{1, 2}), orientation(a, b, c, Projection{1, 2}));
    EXPECT_EQ(orientation(b, a, c, Projection{1, 2}), -orientation(a, b, c, Projection{1, 2}));
  }
}

TEST(Orientation, neitherUnderflowsNorOverflows) {
  for (const int exponent : {-1074, -1000, -500, -120, 0, 120, 500, 1000}) {
    const double s = std::ldexp(1.0, exponent);
    const Vec3 a(0, 0, 0);
    const Vec3 b(s, s, 0);
    const Vec3 c(-s, s, s);
    EXPECT_EQ(orientation(a, b, c, Vec3(s, 2 * s, s)), -orientation(a, b, c, Vec3(-s, -2 * s, -s)));
    EXPECT_NE(orientation(a, b, c, Vec3(s, 2 * s, s)), 0) << exponent;
    EXPECT_EQ(orientation(a, b, c, Vec3(0, 2 * s, s)), 0) << exponent;
    EXPECT_EQ(orientation(a, b, c, Projection{0, 1}), 1) << exponent;
    EXPECT_EQ(orientation(a, b, Vec3(-s, -s, s), Projection{0, 1}), 0) << exponent;
  }
  const double far = 1.7e308;
  EXPECT_EQ(orientation(Vec3(-far, 0, 0), Vec3(far, 1, 1), Vec3(0, far, 3), Vec3(0, 1e-300, far)), 1);
  EXPECT_EQ(orientation(Vec3(-far, -far, 0), Vec3(far, far, 0), Vec3(-1, 1, 0), Projection{0, 1}), 1);
}

}  // namespace
}  // namespace drape::intersection::testing
