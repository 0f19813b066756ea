// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/simd/aggregate_means_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/simd/aggregate_means.hpp"
#include "sim/simd/lanes-inl.hpp"

#include <hwy/highway.h>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::simd::HWY_NAMESPACE {

/// Numbers of an interleaved vector: three coordinates, and one that is never read.
inline constexpr std::size_t numbers = 4;

template <typename T>
HWY_INLINE void interleave(const LaneVectors<T>& from, std::vector<T>& to) {
  const LanesOf<T> d;
  for (std::size_t i = 0; i < to.size() / numbers; i += hn::Lanes(d)) {
    const auto vector = load3(d, from, static_cast<std::ptrdiff_t>(i));
#if HWY_TARGET == HWY_SCALAR
    hn::StoreU(vector.x, d, to.data() + numbers * i);
    hn::StoreU(vector.y, d, to.data() + numbers * i + 1);
    hn::StoreU(vector.z, d, to.data() + numbers * i + 2);
#else
    hn::StoreInterleaved4(vector.x, vector.y, vector.z, vector.z, d, to.data() + numbers * i);
#endif
  }
}

template <class D, typename T>
HWY_INLINE hn::Vec<D> addMember(D d, const AggregateMembers<T>& aggregates, std::size_t m, std::size_t part,
                                hn::Vec<D> sum) {
  const T* const vector = aggregates.positions.data() + numbers * static_cast<std::size_t>(aggregates.indices[m]);
  return hn::MulAdd(hn::Set(d, aggregates.weights[m]), hn::LoadU(d, vector + part), sum);
}

/// With interleaved coordinates each member is fetched by one load. That is faster than one lane for each aggregate,
/// which would need gathers.
template <typename T>
void gather(const LaneVectors<T>& from, AggregateMembers<T>& aggregates, LaneVectors<T>& means) {
  interleave(from, aggregates.positions);
  const hn::CappedTag<T, numbers> d;
  std::array<T, aggregatesPerBatch * numbers> sums{};
  for (std::size_t chunk = 0; chunk + 1 < aggregates.begin.size(); ++chunk) {
    const auto first = aggregatesPerBatch * static_cast<std::size_t>(aggregates.begin[chunk]);
    const auto end = aggregatesPerBatch * static_cast<std::size_t>(aggregates.begin[chunk + 1]);
    for (std::size_t part = 0; part < numbers; part += hn::Lanes(d)) {
      auto a = hn::Zero(d);
      auto b = hn::Zero(d);
      auto c = hn::Zero(d);
      auto e = hn::Zero(d);
      for (std::size_t m = first; m < end; m += aggregatesPerBatch) {
        a = addMember(d, aggregates, m, part, a);
        b = addMember(d, aggregates, m + 1, part, b);
        c = addMember(d, aggregates, m + 2, part, c);
        e = addMember(d, aggregates, m + 3, part, e);
      }
      hn::StoreU(a, d, sums.data() + part);
      hn::StoreU(b, d, sums.data() + numbers + part);
      hn::StoreU(c, d, sums.data() + 2 * numbers + part);
      hn::StoreU(e, d, sums.data() + 3 * numbers + part);
    }
    // The arrays have room for whole slices, beyond the last aggregate.
    for (std::size_t aggregate = 0; aggregate < aggregatesPerBatch; ++aggregate) {
      const T* const mean = sums.data() + numbers * aggregate;
      means.set(aggregatesPerBatch * chunk + aggregate, mean[0], mean[1], mean[2]);
    }
  }
}

void gatherFloat(const LaneVectors<float>& from, AggregateMembers<float>& aggregates, LaneVectors<float>& means) {
  gather(from, aggregates, means);
}

void gatherDouble(const LaneVectors<double>& from, AggregateMembers<double>& aggregates, LaneVectors<double>& means) {
  gather(from, aggregates, means);
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::simd {

HWY_EXPORT(gatherFloat);
HWY_EXPORT(gatherDouble);

void gatherMeans(const LaneVectors<float>& from, AggregateMembers<float>& aggregates, LaneVectors<float>& means) {
  HWY_DYNAMIC_DISPATCH(gatherFloat)(from, aggregates, means);
}

void gatherMeans(const LaneVectors<double>& from, AggregateMembers<double>& aggregates, LaneVectors<double>& means) {
  HWY_DYNAMIC_DISPATCH(gatherDouble)(from, aggregates, means);
}

}  // namespace drape::sim::simd
#endif
