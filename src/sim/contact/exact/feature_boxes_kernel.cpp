// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/contact/exact/feature_boxes_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/contact/exact/feature_boxes.hpp"

#include <hwy/highway.h>
#include <algorithm>
#include <bit>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::contact::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using BoxFloats = hn::CappedTag<float, maxLanes>;

/// Which boxes of a vector from index `at` on overlap box i and belong to none of its patches, as a bit mask.
HWY_INLINE std::uint32_t overlapsOf(const FeatureBoxes& first, int i, const FeatureBoxes& second, int at) {
  const BoxFloats d;
  const hn::RebindToSigned<BoxFloats> di;
  auto overlap = hn::Ge(hn::Zero(d), hn::Zero(d));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto low = hn::LoadU(d, second.low[axis].data() + at);
    const auto high = hn::LoadU(d, second.high[axis].data() + at);
    overlap = hn::And(
        overlap, hn::And(hn::Le(low, hn::Set(d, first.high[axis][i])), hn::Ge(high, hn::Set(d, first.low[axis][i]))));
  }
  for (std::size_t k = 0; k < first.sets; ++k) {
    const std::int32_t patch = first.patches[k].ofFeature[i];
    const auto theirs = hn::LoadU(di, second.patches[k].ofFeature.data() + at);
    const auto isSame = hn::Eq(theirs, hn::Set(di, patch >= 0 ? patch : -2));
    overlap = hn::And(overlap, hn::Not(hn::RebindMask(d, isSame)));
  }
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(d, overlap, bytes.data());
  return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U;
}

/// A leaf of features.
struct Leaf {
  const FeatureBoxes& boxes;
  std::size_t index;

  [[nodiscard]] int begin() const { return boxes.begin[index]; }
  [[nodiscard]] int end() const { return boxes.begin[index] + boxes.count[index]; }

  /// Whether all features of the leaf belong to one patch.
  [[nodiscard]] bool isOfOnePatch() const {
    const auto used = std::span(boxes.patches).first(boxes.sets);
    return std::ranges::any_of(used, [this](const auto& patches) { return patches.ofLeaf[index] >= 0; });
  }

  /// Whether all its features belong to a patch of feature i of other boxes.
  [[nodiscard]] bool isInPatchOf(const FeatureBoxes& others, int i) const {
    for (std::size_t k = 0; k < boxes.sets; ++k) {
      const int patch = boxes.patches[k].ofLeaf[index];
      if (patch >= 0 && patch == others.patches[k].ofFeature[i]) {
        return true;
      }
    }
    return false;
  }
};

/// Calls take(i, k) for the overlapping boxes of different patches.
template <typename Take>
HWY_INLINE void forEachOverlap(const Leaf& outer, const Leaf& inner, Take&& take) {
  const int lanes = static_cast<int>(hn::Lanes(BoxFloats()));
  for (int i = outer.begin(); i < outer.end(); ++i) {
    if (inner.isInPatchOf(outer.boxes, i)) {
      continue;
    }
    for (int k = inner.begin(); k < inner.end(); k += lanes) {
      for (std::uint32_t bits = overlapsOf(outer.boxes, i, inner.boxes, k); bits != 0; bits &= bits - 1) {
        take(i, k + std::countr_zero(bits));
      }
    }
  }
}

void overlaps(const FeatureBoxes& first, std::size_t firstLeaf, const FeatureBoxes& second, std::size_t secondLeaf,
              std::vector<OverlappingBoxes>& found) {
  const Leaf one{first, firstLeaf};
  const Leaf other{second, secondLeaf};
  const auto add = [&](int i, int k) { found.push_back({first.features[i], second.features[k]}); };
  if (&first == &second && firstLeaf == secondLeaf) {
    forEachOverlap(one, other, [&](int i, int k) {
      if (k > i) {
        add(i, k);
      }
    });
  } else if (one.isOfOnePatch() && !other.isOfOnePatch()) {
    // Features of the outer leaf are skipped if they belong to the patch of the whole inner leaf.
    forEachOverlap(other, one, [&](int k, int i) { add(i, k); });
  } else {
    forEachOverlap(one, other, add);
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
