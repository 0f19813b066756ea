// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/simd/group_means_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/simd/group_means.hpp"
#include "sim/simd/lanes-inl.hpp"

#include <hwy/highway.h>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace drape::HWY_NAMESPACE {

/// Numbers that a place takes: its coordinates, and one that is never read.
inline constexpr std::size_t numbers = 4;

template <typename T>
HWY_INLINE void putSideBySide(const LaneVectors<T>& from, std::vector<T>& to) {
  const LanesOf<T> d;
  for (std::size_t i = 0; i < to.size() / numbers; i += hn::Lanes(d)) {
    const auto place = load3(d, from, static_cast<std::ptrdiff_t>(i));
#if HWY_TARGET == HWY_SCALAR
    hn::StoreU(place.x, d, to.data() + numbers * i);
    hn::StoreU(place.y, d, to.data() + numbers * i + 1);
    hn::StoreU(place.z, d, to.data() + numbers * i + 2);
#else
    hn::StoreInterleaved4(place.x, place.y, place.z, place.z, d, to.data() + numbers * i);
#endif
  }
}

template <class D, typename T>
HWY_INLINE hn::Vec<D> addMember(D d, const GroupMembers<T>& groups, std::size_t m, std::size_t part, hn::Vec<D> sum) {
  const T* const place = groups.positions.data() + numbers * static_cast<std::size_t>(groups.places[m]);
  return hn::MulAdd(hn::Set(d, groups.weights[m]), hn::LoadU(d, place + part), sum);
}

/// With the coordinates side by side each member is fetched by one load. That is faster than a lane a group, for which
/// members would have to be gathered from all over.
template <typename T>
void gather(const LaneVectors<T>& from, GroupMembers<T>& groups, LaneVectors<T>& means) {
  putSideBySide(from, groups.positions);
  const hn::CappedTag<T, numbers> d;
  std::array<T, groupsTogether * numbers> sums{};
  for (std::size_t chunk = 0; chunk + 1 < groups.begin.size(); ++chunk) {
    const auto first = groupsTogether * static_cast<std::size_t>(groups.begin[chunk]);
    const auto end = groupsTogether * static_cast<std::size_t>(groups.begin[chunk + 1]);
    for (std::size_t part = 0; part < numbers; part += hn::Lanes(d)) {
      auto a = hn::Zero(d);
      auto b = hn::Zero(d);
      auto c = hn::Zero(d);
      auto e = hn::Zero(d);
      for (std::size_t m = first; m < end; m += groupsTogether) {
        a = addMember(d, groups, m, part, a);
        b = addMember(d, groups, m + 1, part, b);
        c = addMember(d, groups, m + 2, part, c);
        e = addMember(d, groups, m + 3, part, e);
      }
      hn::StoreU(a, d, sums.data() + part);
      hn::StoreU(b, d, sums.data() + numbers + part);
      hn::StoreU(c, d, sums.data() + 2 * numbers + part);
      hn::StoreU(e, d, sums.data() + 3 * numbers + part);
    }
    // Places beyond the last group are there up to a whole slice.
    for (std::size_t group = 0; group < groupsTogether; ++group) {
      const T* const mean = sums.data() + numbers * group;
      means.set(groupsTogether * chunk + group, mean[0], mean[1], mean[2]);
    }
  }
}

void gatherFloat(const LaneVectors<float>& from, GroupMembers<float>& groups, LaneVectors<float>& means) {
  gather(from, groups, means);
}

void gatherDouble(const LaneVectors<double>& from, GroupMembers<double>& groups, LaneVectors<double>& means) {
  gather(from, groups, means);
}

}  // namespace drape::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape {

HWY_EXPORT(gatherFloat);
HWY_EXPORT(gatherDouble);

void gatherMeans(const LaneVectors<float>& from, GroupMembers<float>& groups, LaneVectors<float>& means) {
  HWY_DYNAMIC_DISPATCH(gatherFloat)(from, groups, means);
}

void gatherMeans(const LaneVectors<double>& from, GroupMembers<double>& groups, LaneVectors<double>& means) {
  HWY_DYNAMIC_DISPATCH(gatherDouble)(from, groups, means);
}

}  // namespace drape
#endif
