// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/contact/exact/feature_boxes_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/contact/exact/feature_boxes.hpp"

#include <hwy/highway.h>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::contact::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using BoxFloats = hn::CappedTag<float, maxLanes>;

/// Which boxes of a vector from index `at` on overlap box i.
HWY_INLINE std::uint32_t overlapsOf(const FeatureBoxes& first, int i, const FeatureBoxes& second, int at) {
  const BoxFloats d;
  auto overlap = hn::FirstN(d, hn::Lanes(d));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto low = hn::LoadU(d, second.low[axis].data() + at);
    const auto high = hn::LoadU(d, second.high[axis].data() + at);
    overlap = hn::And(
        overlap, hn::And(hn::Le(low, hn::Set(d, first.high[axis][i])), hn::Ge(high, hn::Set(d, first.low[axis][i]))));
  }
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(d, overlap, bytes.data());
  return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U;
}

void overlaps(const FeatureBoxes& first, std::size_t firstLeaf, const FeatureBoxes& second, std::size_t secondLeaf,
              std::vector<OverlappingBoxes>& found) {
  const int lanes = static_cast<int>(hn::Lanes(BoxFloats()));
  const bool same = &first == &second && firstLeaf == secondLeaf;
  const int end = first.begin[firstLeaf] + first.count[firstLeaf];
  const int secondEnd = second.begin[secondLeaf] + second.count[secondLeaf];
  for (int i = first.begin[firstLeaf]; i < end; ++i) {
    for (int k = second.begin[secondLeaf]; k < secondEnd; k += lanes) {
      for (std::uint32_t bits = overlapsOf(first, i, second, k); bits != 0; bits &= bits - 1) {
        const int other = k + std::countr_zero(bits);
        if (!same || other > i) {
          found.push_back({first.features[i], second.features[other]});
        }
      }
    }
  }
}

}  // namespace drape::sim::contact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::contact {

HWY_EXPORT(overlaps);

void findOverlaps(const FeatureBoxes& first, std::size_t firstLeaf, const FeatureBoxes& second, std::size_t secondLeaf,
                  std::vector<OverlappingBoxes>& found) {
  found.clear();
  HWY_DYNAMIC_DISPATCH(overlaps)(first, firstLeaf, second, secondLeaf, found);
}

}  // namespace drape::sim::contact
#endif
