#include "sim/contact/exact/pair_separation.hpp"

#include "contact/exact/exact_motion.hpp"
#include "sim/contact/exact/near_pairs.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

namespace drape::sim::contact {
namespace {

using testing::PairMotion;
using testing::provablyStaysApart;

constexpr double smallestThickness = 0.001;  // the smallest that can be set [m]
constexpr double goalDistance = 0.1 * smallestThickness;

/// Random numbers for pairs.
class Source {
 public:
  explicit Source(unsigned seed) : engine_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  /// A number between two powers of ten, evenly in its logarithm, with either sign.
  double ofSize(double lowest, double highest) {
    return std::pow(10.0, between(lowest, highest)) * (between(-1.0, 1.0) < 0.0 ? -1.0 : 1.0);
  }
  Vec3 point(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }
  Vec3 direction() {
    Vec3 found = point(1.0);
    return found.norm() > 0.1 ? Vec3(found.normalized()) : direction();
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937 engine_;
};

/// A pair of features of a few centimetres that is about as far apart as it moves, from far below the thickness to
/// many of it.
PairMotion randomPair(Source& source, std::size_t firstCount) {
  PairMotion pair{.start = {}, .end = {}, .firstCount = firstCount};
  const double gap = std::abs(source.ofSize(-7.0, -1.5));
  const double move = gap * std::abs(source.ofSize(-1.0, 1.0));
  for (Vec3& corner : pair.start) {
    corner = source.point(0.02);
  }
  // Moves the first feature next to a random point of the second.
  const double s = source.between(0.0, 1.0);
  const double t = source.between(0.0, 1.0 - s);
  auto& [a, b, c, d] = pair.start;
  const Vec3 target = firstCount == 2 ? Vec3(c + s * (d - c)) : Vec3(b + s * (c - b) + t * (d - b));
  const Vec3 own = firstCount == 2 ? Vec3(a + source.between(0.0, 1.0) * (b - a)) : a;
  const Vec3 shift = target - own + gap * source.direction();
  for (std::size_t k = 0; k < firstCount; ++k) {
    pair.start[k] += shift;
  }
  const Vec3 common = source.point(0.1);
  for (std::size_t k = 0; k < 4; ++k) {
    pair.end[k] = pair.start[k] + common + source.point(move);
  }
  return pair;
}

void forAllPoints(PairMotion& pair, const std::function<void(Vec3&)>& change) {
  for (auto* points : {&pair.start, &pair.end}) {
    for (Vec3& point : *points) {
      change(point);
    }
  }
}

/// Makes the second edge parallel to the first up to an angle, or the triangle a sliver of that ratio, at the start and
/// sometimes at the end.
void makeThin(Source& source, PairMotion& pair, double angle) {
  const bool atEnd = source.below(2) == 0;
  for (auto* points : {&pair.start, &pair.end}) {
    auto& [a, b, c, d] = *points;
    if (points == &pair.start || atEnd) {
      const Vec3 along = pair.firstCount == 2 ? Vec3(b - a) : Vec3(c - b);
      const Vec3& from = pair.firstCount == 2 ? c : b;
      d = from + source.between(-1.5, 1.5) * along + angle * source.point(along.norm());
    }
  }
}

/// Moves a vertex of the first feature onto a point of the second one, but for rounding, or very close to it.
void makeTouching(Source& source, PairMotion& pair) {
  auto& points = source.below(2) == 0 ? pair.start : pair.end;
  auto& [a, b, c, d] = points;
  const double s = source.below(3) / 2.0;
  const double t = source.below(2) == 0 ? 0.0 : source.between(0.0, 1.0 - s);
  a = pair.firstCount == 2 ? Vec3(c + s * (d - c)) : Vec3(b + s * (c - b) + t * (d - b));
  if (source.below(4) != 0) {
    a += std::abs(source.ofSize(-18.0, -9.0)) * source.direction();
  }
}

void makeFlat(Source& source, PairMotion& pair) {
  const bool always = source.below(2) == 0;
  const double height = source.below(2) == 0 ? 0.0 : source.ofSize(-16.0, -6.0);
  for (Vec3& point : pair.start) {
    point.y() = height * source.between(-1.0, 1.0);
  }
  for (Vec3& point : pair.end) {
    point.y() = always ? 0.0 : point.y();
  }
}

void makeDegenerate(Source& source, PairMotion& pair) {
  const int from = source.below(4);
  const int to = source.below(4);
  pair.start[from] = pair.start[to];
  pair.end[from] = source.below(2) == 0 ? pair.end[to] : pair.end[from];
}

struct Family {
  const char* name;
  void (*change)(Source& source, PairMotion& pair);
};

void PrintTo(const Family& family, std::ostream* out) {
  *out << family.name;
}

constexpr Family families[] = {
    {"random", [](Source&, PairMotion&) {}},
    {"fast",
     [](Source& source, PairMotion& pair) {
       for (Vec3& point : pair.end) {
         point += source.point(3.0);
       }
     }},
    {"parallel or without area", [](Source& source, PairMotion& pair) { makeThin(source, pair, 0.0); }},
    {"nearly parallel or slivers",
     [](Source& source, PairMotion& pair) { makeThin(source, pair, std::abs(source.ofSize(-14.0, -2.0))); }},
    {"touching", makeTouching},
    {"coplanar", makeFlat},
    {"corners at the same place", makeDegenerate},
    {"far from the origin",
     [](Source& source, PairMotion& pair) {
       const Vec3 origin = source.point(std::abs(source.ofSize(2.0, 7.0)));
       forAllPoints(pair, [&](Vec3& point) { point += origin; });
     }},
    {"far from the origin and thin",
     [](Source& source, PairMotion& pair) {
       makeThin(source, pair, std::abs(source.ofSize(-14.0, -2.0)));
       const Vec3 origin = source.point(std::abs(source.ofSize(2.0, 7.0)));
       forAllPoints(pair, [&](Vec3& point) { point += origin; });
     }},
    {"turning",
     [](Source& source, PairMotion& pair) {
       const Eigen::AngleAxisd turn(source.between(-3.0, 3.0), source.direction());
       for (std::size_t k = 0; k < 4; ++k) {
         pair.end[k] = turn * pair.start[k] + 0.1 * (pair.end[k] - pair.start[k]);
       }
     }},
    {"minute",
     [](Source& source, PairMotion& pair) {
       const double scale = std::abs(source.ofSize(-12.0, -3.0));
       forAllPoints(pair, [&](Vec3& point) { point *= scale; });
     }},
    {"huge",
     [](Source& source, PairMotion& pair) {
       const double scale = std::abs(source.ofSize(1.0, 5.0));
       forAllPoints(pair, [&](Vec3& point) { point *= scale; });
     }},
};

PairInStep certificateOf(const PairMotion& pair, double kept) {
  return separationInStep({{0, 1, 2, 3}, pair.firstCount}, pair.start, pair.end, {goalDistance, kept});
}

std::string written(const PairMotion& pair) {
  std::string text = pair.firstCount == 2 ? "edges" : "vertex and triangle";
  for (const auto* points : {&pair.start, &pair.end}) {
    for (const Vec3& point : *points) {
      for (const double x : point) {
        std::array<char, 40> number{};
        std::snprintf(number.data(), number.size(), " %a", x);
        text += number.data();
      }
    }
  }
  return text;
}

class SeparationOfFamily : public ::testing::TestWithParam<Family> {};

// The million pairs that the families contain together.
TEST_P(SeparationOfFamily, passesNoPairThatMeetsByRationalArithmetic) {
  constexpr int count = 1'000'000 / static_cast<int>(std::size(families)) + 1;
  Source source(1);
  int passed = 0;
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    PairMotion pair = randomPair(source, i % 2 == 0 ? 1 : 2);
    GetParam().change(source, pair);
    const double kept = source.below(4) == 0 ? std::abs(source.ofSize(-12.0, -5.0)) : goalDistance;
    const PairInStep::Kind kind = certificateOf(pair, kept).kind;
    if (kind == PairInStep::Kind::Separated) {
      ++passed;
      ASSERT_TRUE(provablyStaysApart(pair)) << written(pair);
    } else {
      ++refused;
    }
  }
  EXPECT_GT(passed, count / 50);
  EXPECT_GT(refused, count / 50);
}

// What the vector loops decide without the certificate.
TEST_P(SeparationOfFamily, vectorLoopsPassNoPairThatMeetsByRationalArithmetic) {
  constexpr int count = 20'000;
  Source source(1);
  for (const std::size_t firstCount : {1U, 2U}) {
    std::vector<Vec3> start, end;
    PairLanes lanes;
    std::vector<PairMotion> pairs;
    for (int i = 0; i < count; ++i) {
      PairMotion pair = randomPair(source, firstCount);
      GetParam().change(source, pair);
      lanes.add({4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
      start.insert(start.end(), pair.start.begin(), pair.start.end());
      end.insert(end.end(), pair.end.begin(), pair.end.end());
      pairs.push_back(pair);
    }
    Approach approach;
    std::vector<double> distances;
    measureApproach(firstCount == 2, lanes, start.data(), end.data(), approach);
    measureDistances(firstCount == 2, lanes, start.data(), distances);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (staysApart(approach, i, goalDistance)) {
        ASSERT_TRUE(provablyStaysApart(pairs[i])) << written(pairs[i]);
      }
      if (distances[i] > goalDistance) {
        pairs[i].end = pairs[i].start;
        ASSERT_TRUE(provablyStaysApart(pairs[i])) << written(pairs[i]);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, SeparationOfFamily, ::testing::ValuesIn(families), [](const auto& instance) {
  std::string name = instance.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

/// A pair whose features have a common point at the time 1/2, without any rounding: all coordinates are small multiples
/// of a power of two.
PairMotion meetingPair(Source& source, std::size_t firstCount) {
  constexpr int eighths = 8;
  const double unit = std::ldexp(1.0, -source.below(30) - 10);
  const auto lattice = [&](int size) {
    const auto number = [&]() { return eighths * (source.below(2 * size + 1) - size) * unit; };
    return Vec3(number(), number(), number());
  };
  std::array<Vec3, 4> half;
  for (Vec3& point : half) {
    point = lattice(60);
  }
  auto& [a, b, c, d] = half;
  if (source.below(3) == 0) {
    a.y() = b.y() = c.y() = d.y() = 0.0;
  }
  const double s = source.below(eighths + 1) / static_cast<double>(eighths);
  if (firstCount == 2) {
    const Vec3 target = c + s * (d - c);
    // The first edge passes through the target, or ends there.
    const Vec3 along = lattice(20);
    a = target - source.below(3) * along;
    b = target + source.below(3) * along;
  } else {
    const double t = source.below(static_cast<int>(eighths * (1.0 - s)) + 1) / static_cast<double>(eighths);
    a = b + s * (c - b) + t * (d - b);
  }
  PairMotion pair{.start = half, .end = half, .firstCount = firstCount};
  const int speed = 1 + source.below(200);
  const Vec3 common = lattice(100);
  for (std::size_t k = 0; k < 4; ++k) {
    Vec3 move = lattice(speed) + common;
    move.y() = source.below(4) == 0 ? 0.0 : move.y();
    pair.start[k] -= move;
    pair.end[k] += move;
  }
  const Vec3 origin = source.below(3) == 0 ? Vec3(lattice(100) / unit) : Vec3(Vec3::Zero());
  forAllPoints(pair, [&](Vec3& point) { point += origin; });
  return pair;
}

TEST(SeparationInStep, refusesPairsThatMeetInTheMiddleOfTheStep) {
  Source source(11);
  for (int i = 0; i < 300'000; ++i) {
    const PairMotion pair = meetingPair(source, i % 2 == 0 ? 1 : 2);
    for (const double kept : {goalDistance, 1e-12}) {
      ASSERT_NE(certificateOf(pair, kept).kind, PairInStep::Kind::Separated) << written(pair);
    }
  }
}

TEST(SeparationInStep, isJudgedByProofsThatDoNotExistForPairsThatMeet) {
  Source source(12);
  for (int i = 0; i < 40; ++i) {
    const PairMotion pair = meetingPair(source, i % 2 == 0 ? 1 : 2);
    ASSERT_FALSE(provablyStaysApart(pair)) << written(pair);
  }
}

TEST(SeparationInStep, passesClosePairsThatTurnTogether) {
  for (const std::size_t firstCount : {1U, 2U}) {
    PairMotion pair{.start = {}, .end = {}, .firstCount = firstCount};
    pair.start = {Vec3(0.01, 2e-5, 0.01), Vec3(-0.03, 0.0, -0.02), Vec3(0.05, 0.0, -0.01), Vec3(0.0, 0.0, 0.05)};
    if (firstCount == 2) {
      pair.start = {Vec3(-0.04, 2e-5, 0.0), Vec3(0.04, 2e-5, 0.0), Vec3(0.0, 0.0, -0.03), Vec3(0.0, 0.0, 0.05)};
    }
    for (const double angle : {0.001, 0.01, 0.03}) {
      for (std::size_t k = 0; k < 4; ++k) {
        pair.end[k] = Eigen::AngleAxisd(angle, Vec3(1.0, 0.2, 2.0).normalized()) * pair.start[k];
      }
      EXPECT_EQ(certificateOf(pair, 1.9e-5).kind, PairInStep::Kind::Separated) << firstCount << ' ' << angle;
      PairMotion crossing = pair;
      crossing.end[0].y() -= 1e-3;
      EXPECT_EQ(certificateOf(crossing, 1.9e-5).kind, PairInStep::Kind::NotSeparated) << firstCount << ' ' << angle;
    }
  }
}

TEST(SeparationInStep, passesPairsThatStayApart) {
  Source source(13);
  int passed = 0;
  for (int i = 0; i < 20'000; ++i) {
    PairMotion pair = randomPair(source, i % 2 == 0 ? 1 : 2);
    // The first feature moves away from the second along a normal that separates them.
    const PairGap gap = gapOf({{0, 1, 2, 3}, pair.firstCount}, pair.start);
    pair.end = pair.start;
    for (std::size_t k = 0; k < pair.firstCount; ++k) {
      pair.end[k] += source.between(0.0, 0.1) * gap.normal;
    }
    if (separationAlong(gap.normal, {{0, 1, 2, 3}, pair.firstCount}, pair.start) > 0.0) {
      ++passed;
      ASSERT_EQ(certificateOf(pair, goalDistance).kind, PairInStep::Kind::Separated) << written(pair);
    }
  }
  EXPECT_GT(passed, 15'000);
}

}  // namespace
}  // namespace drape::sim::contact
