#include "contact/exact/exact_motion.hpp"

#include <gmpxx.h>

#include <cmath>
#include <limits>
#include <vector>

namespace drape::sim::testing {
namespace {

using Real = long double;
using RealPoint = Eigen::Matrix<Real, 3, 1>;
using ExactPoint = std::array<mpq_class, 3>;

constexpr int maxDepth = 48;
constexpr int maxIntervals = 20000;

/// A vertex relative to the first one at a time, in extended precision.
RealPoint offsetAt(const PairMotion& motion, std::size_t k, Real time) {
  const RealPoint start = motion.start[k].cast<Real>() - motion.start[0].cast<Real>();
  const RealPoint end = motion.end[k].cast<Real>() - motion.end[0].cast<Real>();
  return (1 - time) * start + time * end;
}

/// A bound for the rounding error of a product of a vector with offsetAt: its about ten operations have errors of half
/// an epsilon each.
Real errorOf(const PairMotion& motion, std::size_t k, const RealPoint& direction) {
  const RealPoint size = (motion.start[k].cast<Real>().cwiseAbs() + motion.start[0].cast<Real>().cwiseAbs() +
                          motion.end[k].cast<Real>().cwiseAbs() + motion.end[0].cast<Real>().cwiseAbs());
  return 16 * std::numeric_limits<Real>::epsilon() * direction.cwiseAbs().dot(size);
}

enum class Answer { Yes, No, Unknown };

/// Whether the first feature lies above the second, as far as rounding errors allow to tell.
Answer isAboveByBounds(const PairMotion& motion, const RealPoint& direction, Real time) {
  Real low = std::numeric_limits<Real>::infinity();
  Real high = -low;
  Real error = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Real product = direction.dot(offsetAt(motion, k, time));
    error = std::max(error, errorOf(motion, k, direction));
    (k < motion.firstCount ? low : high) = k < motion.firstCount ? std::min(low, product) : std::max(high, product);
  }
  return low - high > 2 * error ? Answer::Yes : low - high < -2 * error ? Answer::No : Answer::Unknown;
}

mpq_class heightOf(const PairMotion& motion, const RealPoint& direction, std::size_t k, const mpq_class& time) {
  mpq_class height = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const mpq_class start(motion.start[k][axis]);
    const mpq_class end(motion.end[k][axis]);
    height += mpq_class(static_cast<double>(direction[axis])) * (start + time * (end - start));
  }
  return height;
}

bool isAboveExactly(const PairMotion& motion, const RealPoint& direction, double time) {
  const mpq_class exactTime(time);
  for (std::size_t i = 0; i < motion.firstCount; ++i) {
    for (std::size_t k = motion.firstCount; k < 4; ++k) {
      if (heightOf(motion, direction, i, exactTime) <= heightOf(motion, direction, k, exactTime)) {
        return false;
      }
    }
  }
  return true;
}

/// Whether the first feature lies above the second at two times.
/// @param direction has coordinates that are doubles  @param from, to multiples of 2^-maxDepth, so that they are exact
bool isAboveAtBoth(const PairMotion& motion, const RealPoint& direction, double from, double to) {
  const Answer first = isAboveByBounds(motion, direction, from);
  const Answer last = first == Answer::No ? first : isAboveByBounds(motion, direction, to);
  return last != Answer::No && (first == Answer::Yes || isAboveExactly(motion, direction, from)) &&
         (last == Answer::Yes || isAboveExactly(motion, direction, to));
}

/// Candidates for a direction that separates the pair at a time.
std::vector<RealPoint> directionsAt(const PairMotion& motion, double time) {
  std::array<Vec3, 4> at;
  for (std::size_t k = 0; k < 4; ++k) {
    at[k] = offsetAt(motion, k, time).cast<double>();
  }
  const auto& [a, b, c, d] = at;
  std::vector<Vec3> found = {contact::gapOf({{0, 1, 2, 3}, motion.firstCount}, at).normal};
  if (motion.firstCount == 2) {
    found.emplace_back((b - a).cross(d - c));
    found.emplace_back((b - a).cross(c - a).cross(b - a));
    found.emplace_back((d - c).cross(c - a).cross(d - c));
  } else {
    found.emplace_back((c - b).cross(d - b));
    found.emplace_back((c - b).cross(a - b).cross(c - b));
    found.emplace_back((d - c).cross(a - c).cross(d - c));
    found.emplace_back((b - d).cross(a - d).cross(b - d));
  }
  std::vector<RealPoint> directions;
  for (const Vec3& direction : found) {
    const double size = direction.cwiseAbs().maxCoeff();
    if (size > 0.0) {
      directions.emplace_back((direction / size).cast<Real>());
      directions.emplace_back(-directions.back());
    }
  }
  return directions;
}

bool isProvedFor(const PairMotion& motion, double from, double to, int depth, int& intervals) {
  if (++intervals > maxIntervals) {
    return false;
  }
  const double middle = 0.5 * (from + to);
  for (const double time : {from, to, middle}) {
    for (const RealPoint& direction : directionsAt(motion, time)) {
      if (isAboveAtBoth(motion, direction, from, to)) {
        return true;
      }
    }
  }
  return depth < maxDepth && isProvedFor(motion, from, middle, depth + 1, intervals) &&
         isProvedFor(motion, middle, to, depth + 1, intervals);
}

}  // namespace

bool provablyStaysApart(const PairMotion& motion) {
  int intervals = 0;
  return isProvedFor(motion, 0.0, 1.0, 0, intervals);
}

}  // namespace drape::sim::testing
