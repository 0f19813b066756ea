// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/simd/convert_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/simd/convert.hpp"
#include "sim/simd/slice_layout.hpp"

#include <hwy/highway.h>
#include <array>
#include <bit>
#include <numeric>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, sliceLanes>;

template <typename T>
HWY_INLINE void storeAs(hn::Vec<Doubles> value, T* to) {
  if constexpr (sizeof(T) == sizeof(float)) {
    const hn::Rebind<float, Doubles> narrow;
    hn::StoreU(hn::DemoteTo(narrow, value), narrow, to);
  } else {
    hn::StoreU(value, Doubles(), to);
  }
}

template <typename T>
HWY_INLINE hn::Vec<Doubles> loadFrom(const T* from) {
  if constexpr (sizeof(T) == sizeof(float)) {
    return hn::PromoteTo(Doubles(), hn::LoadU(hn::Rebind<float, Doubles>(), from));
  } else {
    return hn::LoadU(Doubles(), from);
  }
}

template <typename T>
void split(const double* from, std::size_t count, const Vec3& origin, const Coordinates<T>& to) {
  [[maybe_unused]] const Doubles d;
  std::size_t i = 0;
#if HWY_TARGET != HWY_SCALAR
  for (const std::size_t lanes = hn::Lanes(d); i + lanes <= count; i += lanes) {
    hn::Vec<Doubles> x;
    hn::Vec<Doubles> y;
    hn::Vec<Doubles> z;
    hn::LoadInterleaved3(d, from + 3 * i, x, y, z);
    storeAs(hn::Sub(x, hn::Set(d, origin.x())), to.x + i);
    storeAs(hn::Sub(y, hn::Set(d, origin.y())), to.y + i);
    storeAs(hn::Sub(z, hn::Set(d, origin.z())), to.z + i);
  }
#endif
  for (; i < count; ++i) {
    to.x[i] = static_cast<T>(from[3 * i] - origin.x());
    to.y[i] = static_cast<T>(from[3 * i + 1] - origin.y());
    to.z[i] = static_cast<T>(from[3 * i + 2] - origin.z());
  }
}

template <typename T>
void join(const Coordinates<T>& from, std::size_t count, const Vec3& origin, double* to) {
  [[maybe_unused]] const Doubles d;
  std::size_t i = 0;
#if HWY_TARGET != HWY_SCALAR
  for (const std::size_t lanes = hn::Lanes(d); i + lanes <= count; i += lanes) {
    hn::StoreInterleaved3(hn::Add(loadFrom(from.x + i), hn::Set(d, origin.x())),
                          hn::Add(loadFrom(from.y + i), hn::Set(d, origin.y())),
                          hn::Add(loadFrom(from.z + i), hn::Set(d, origin.z())), d, to + 3 * i);
  }
#endif
  for (; i < count; ++i) {
    to[3 * i] = static_cast<double>(from.x[i]) + origin.x();
    to[3 * i + 1] = static_cast<double>(from.y[i]) + origin.y();
    to[3 * i + 2] = static_cast<double>(from.z[i]) + origin.z();
  }
}

void splitFloat(const double* from, std::size_t count, const Vec3& origin, const Coordinates<float>& to) {
  split(from, count, origin, to);
}
void splitDouble(const double* from, std::size_t count, const Vec3& origin, const Coordinates<double>& to) {
  split(from, count, origin, to);
}
void joinFloat(const Coordinates<float>& from, std::size_t count, const Vec3& origin, double* to) {
  join(from, count, origin, to);
}
void joinDouble(const Coordinates<double>& from, std::size_t count, const Vec3& origin, double* to) {
  join(from, count, origin, to);
}

std::uint64_t sumBits(const double* values, std::size_t count) {
  const hn::ScalableTag<std::uint64_t> d;
  const std::size_t lanes = hn::Lanes(d);
  auto sum = hn::Zero(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    sum = hn::Add(sum, hn::BitCast(d, hn::LoadU(hn::RebindToFloat<decltype(d)>(), values + i)));
  }
  // Lane by lane: for AVX-512 the compiler's reduction is signed, and its overflow is undefined behaviour.
  HWY_ALIGN std::array<std::uint64_t, HWY_MAX_BYTES / sizeof(std::uint64_t)> parts{};
  hn::Store(sum, d, parts.data());
  std::uint64_t all = std::accumulate(parts.begin(), parts.end(), std::uint64_t{0});
  for (; i < count; ++i) {
    all += std::bit_cast<std::uint64_t>(values[i]);
  }
  return all;
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::simd {

HWY_EXPORT(splitFloat);
HWY_EXPORT(splitDouble);
HWY_EXPORT(joinFloat);
HWY_EXPORT(joinDouble);
HWY_EXPORT(sumBits);

void splitCoordinates(const double* from, std::size_t count, const Vec3& origin, const Coordinates<float>& to) {
  HWY_DYNAMIC_DISPATCH(splitFloat)(from, count, origin, to);
}

void splitCoordinates(const double* from, std::size_t count, const Vec3& origin, const Coordinates<double>& to) {
  HWY_DYNAMIC_DISPATCH(splitDouble)(from, count, origin, to);
}

void joinCoordinates(const Coordinates<float>& from, std::size_t count, const Vec3& origin, double* to) {
  HWY_DYNAMIC_DISPATCH(joinFloat)(from, count, origin, to);
}

void joinCoordinates(const Coordinates<double>& from, std::size_t count, const Vec3& origin, double* to) {
  HWY_DYNAMIC_DISPATCH(joinDouble)(from, count, origin, to);
}

std::uint64_t sumOfBits(const double* values, std::size_t count) {
  return HWY_DYNAMIC_DISPATCH(sumBits)(values, count);
}

}  // namespace drape::sim::simd
#endif
