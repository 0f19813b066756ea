#include "intersection/orientation.hpp"

#include <gmpxx.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace drape::intersection {
namespace {

using Point = Eigen::Vector3d;

/// Half an ulp of 1, as in Shewchuk's bounds.
constexpr double epsilon = std::numeric_limits<double>::epsilon() / 2.0;
constexpr double volumeBound = (7.0 + 56.0 * epsilon) * epsilon;
constexpr double areaBound = (3.0 + 16.0 * epsilon) * epsilon;

/// The bounds are valid without overflow and underflow. With differences up to `largest` products do not overflow, and
/// the total error by underflow is below `underflow`.
constexpr double largest = 1e30;
constexpr double underflow = 1e-290;

/// Maximum length of integer coordinates for shortVolumeSign and shortAreaSign [bits].
constexpr int shortBits = 60;

__extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using)

/// One coordinate of all points. Scaling it by a power of two does not change signs of volumes.
template <std::size_t N>
using Coordinates = std::array<double, N>;
template <std::size_t N>
using Short = std::array<std::int64_t, N>;

/// The absolute value of a double as mantissa * 2^exponent, with an odd mantissa or 0.
struct Parts {
  std::uint64_t mantissa = 0;
  int exponent = 0;

  explicit Parts(double value) {
    constexpr int storedBits = 52;
    constexpr int bias = 1023 + storedBits;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const auto power = static_cast<int>(bits >> storedBits & 0x7FFU);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << storedBits) - 1);
    mantissa = power == 0 ? fraction : fraction | std::uint64_t{1} << storedBits;
    if (mantissa != 0) {
      const int zeros = std::countr_zero(mantissa);
      mantissa >>= zeros;
      exponent = std::max(power, 1) - bias + zeros;
    }
  }
};

/// Converts coordinates to integers below 2^60, times one power of two. Returns false if their magnitudes differ too
/// much.
template <std::size_t N>
bool toShort(const Coordinates<N>& values, Short<N>& whole) {
  int lowest = std::numeric_limits<int>::max();
  int highest = std::numeric_limits<int>::min();
  for (const double value : values) {
    const Parts parts(value);
    if (parts.mantissa != 0) {
      lowest = std::min(lowest, parts.exponent);
      highest = std::max(highest, parts.exponent + static_cast<int>(std::bit_width(parts.mantissa)));
    }
  }
  if (highest > lowest + shortBits) {
    return false;
  }
  for (std::size_t i = 0; i < N; ++i) {
    const Parts parts(values[i]);
    const auto size = static_cast<std::int64_t>(parts.mantissa << (parts.mantissa == 0 ? 0 : parts.exponent - lowest));
    whole[i] = std::signbit(values[i]) ? -size : size;
  }
  return true;
}

/// The same with integers of any length.
template <std::size_t N>
std::array<mpz_class, N> toLong(const Coordinates<N>& values) {
  int lowest = std::numeric_limits<int>::max();
  for (const double value : values) {
    lowest = value == 0.0 ? lowest : std::min(lowest, Parts(value).exponent);
  }
  std::array<mpz_class, N> whole;
  for (std::size_t i = 0; i < N; ++i) {
    const Parts parts(values[i]);
    whole[i] = std::copysign(static_cast<double>(parts.mantissa), values[i]);
    whole[i] <<= static_cast<mp_bitcnt_t>(parts.mantissa == 0 ? 0 : parts.exponent - lowest);
  }
  return whole;
}

/// The sign of x . m, for |x| < 2^61 and |m| < 2^123: m is split into its upper and lower 64 bits.
int signOfSum(const std::array<std::int64_t, 3>& x, const std::array<Wide, 3>& m) {
  constexpr int half = 64;
  Wide upper = 0;
  Wide lower = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    upper += static_cast<Wide>(x[i]) * static_cast<std::int64_t>(m[i] >> half);
    lower += static_cast<Wide>(x[i]) * static_cast<Wide>(static_cast<std::uint64_t>(m[i]));
  }
  upper += lower >> half;
  const bool rest = static_cast<std::uint64_t>(lower) != 0;
  return upper > 0 || (upper == 0 && rest) ? 1 : upper < 0 ? -1 : 0;
}

/// (b - a) . ((c - a) x (d - a)) of integer coordinates x, y, z of a, b, c, d.
int shortVolumeSign(const std::array<Short<4>, 3>& whole) {
  const auto& [x, y, z] = whole;
  const auto minor = [](const Short<4>& u, const Short<4>& v) {
    return static_cast<Wide>(u[2] - u[0]) * (v[3] - v[0]) - static_cast<Wide>(v[2] - v[0]) * (u[3] - u[0]);
  };
  return signOfSum({x[1] - x[0], y[1] - y[0], z[1] - z[0]}, {minor(y, z), minor(z, x), minor(x, y)});
}

int longVolumeSign(const std::array<Coordinates<4>, 3>& axes) {
  const auto x = toLong(axes[0]);
  const auto y = toLong(axes[1]);
  const auto z = toLong(axes[2]);
  const auto minor = [](const auto& u, const auto& v) -> mpz_class {
    return (u[2] - u[0]) * (v[3] - v[0]) - (v[2] - v[0]) * (u[3] - u[0]);
  };
  const mpz_class volume = (x[1] - x[0]) * minor(y, z) + (y[1] - y[0]) * minor(z, x) + (z[1] - z[0]) * minor(x, y);
  return sgn(volume);
}

int exactVolumeSign(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto along = [&](int axis) { return Coordinates<4>{a[axis], b[axis], c[axis], d[axis]}; };
  const std::array<Coordinates<4>, 3> axes = {along(0), along(1), along(2)};
  std::array<Short<4>, 3> whole{};
  if (toShort(axes[0], whole[0]) && toShort(axes[1], whole[1]) && toShort(axes[2], whole[2])) {
    return shortVolumeSign(whole);
  }
  return longVolumeSign(axes);
}

int exactAreaSign(const Point& a, const Point& b, const Point& c, Projection p) {
  const Coordinates<3> alongU = {a[p.u], b[p.u], c[p.u]};
  const Coordinates<3> alongV = {a[p.v], b[p.v], c[p.v]};
  Short<3> u{};
  Short<3> v{};
  if (toShort(alongU, u) && toShort(alongV, v)) {
    const Wide area = static_cast<Wide>(u[1] - u[0]) * (v[2] - v[0]) - static_cast<Wide>(v[1] - v[0]) * (u[2] - u[0]);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
  }
  const auto x = toLong(alongU);
  const auto y = toLong(alongV);
  const mpz_class area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
  return sgn(area);
}

int signBeyond(double value, double bound) {
  return value > bound ? 1 : value < -bound ? -1 : 0;
}

/// The sign, or 0 if the rounding error exceeds the value.
int roundedVolumeSign(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point ab = b - a;
  const Point ac = c - a;
  const Point ad = d - a;
  const Point left = {ac[1] * ad[2], ac[2] * ad[0], ac[0] * ad[1]};
  const Point right = {ac[2] * ad[1], ac[0] * ad[2], ac[1] * ad[0]};
  const double volume = ab.dot(left - right);
  const double permanent = ab.cwiseAbs().dot(left.cwiseAbs() + right.cwiseAbs());
  const double spread = ab.cwiseAbs().cwiseMax(ac.cwiseAbs()).cwiseMax(ad.cwiseAbs()).maxCoeff();
  return spread < largest ? signBeyond(volume, volumeBound * permanent + underflow) : 0;
}

int roundedAreaSign(const Point& a, const Point& b, const Point& c, Projection p) {
  const double left = (b[p.u] - a[p.u]) * (c[p.v] - a[p.v]);
  const double right = (b[p.v] - a[p.v]) * (c[p.u] - a[p.u]);
  const double permanent = std::abs(left) + std::abs(right);
  return permanent < largest ? signBeyond(left - right, areaBound * permanent + underflow) : 0;
}

/// Whether all points have equal coordinates along an axis.
template <typename... Points>
bool allLevel(int axis, const Point& first, const Points&... others) {
  return ((others[axis] == first[axis]) && ...);
}

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (const int sign = roundedVolumeSign(a, b, c, d); sign != 0) {
    return sign;
  }
  if (allLevel(0, a, b, c, d) || allLevel(1, a, b, c, d) || allLevel(2, a, b, c, d)) {
    return 0;
  }
  return exactVolumeSign(a, b, c, d);
}

bool isPassedByLine(const std::array<Point, 3>& triangle, const Point& from, const Point& to) {
  // The line passes all three sides in the same sense.
  const auto& [a, b, c] = triangle;
  const int ab = orientation(from, to, a, b);
  const int bc = orientation(from, to, b, c);
  const int ca = orientation(from, to, c, a);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

int orientation(const Point& a, const Point& b, const Point& c, Projection p) {
  if (const int sign = roundedAreaSign(a, b, c, p); sign != 0) {
    return sign;
  }
  if (allLevel(p.u, a, b, c) || allLevel(p.v, a, b, c)) {
    return 0;
  }
  return exactAreaSign(a, b, c, p);
}

}  // namespace drape::intersection
