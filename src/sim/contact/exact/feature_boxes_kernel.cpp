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

using BoxFloats = hn::CappedTag<float, blockLanes>;

/// A bit mask of a vector's lanes.
template <typename Mask>
HWY_INLINE std::uint32_t bitsOf(Mask mask) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(BoxFloats(), mask, bytes.data());
  static_assert(blockLanes <= 8, "the first byte has the bits of all lanes");
  return bytes[0];
}

/// Which boxes of a block from a lane on overlap a box.
HWY_INLINE auto overlapping(const LaneBox& box, const FeatureBlock& block, std::size_t lane) {
  const BoxFloats d;
  auto overlap = hn::Ge(hn::Zero(d), hn::Zero(d));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto low = hn::LoadU(d, block.low[axis].data() + lane);
    const auto high = hn::LoadU(d, block.high[axis].data() + lane);
    overlap =
        hn::And(overlap, hn::And(hn::Le(low, hn::Set(d, box.high[axis])), hn::Ge(high, hn::Set(d, box.low[axis]))));
  }
  return overlap;
}

/// A feature of the outer leaf.
struct Feature {
  const FeatureBlock& block;
  std::size_t lane;

  [[nodiscard]] LaneBox box() const {
    return {{block.low[0][lane], block.low[1][lane], block.low[2][lane]},
            {block.high[0][lane], block.high[1][lane], block.high[2][lane]}};
  }
  [[nodiscard]] bool isInPatchOf(const FeatureBoxes::Leaf& leaf, std::size_t sets) const {
    for (std::size_t k = 0; k < sets; ++k) {
      if (leaf.patches[k] >= 0 && leaf.patches[k] == block.patches[k][lane]) {
        return true;
      }
    }
    return false;
  }
};

/// Which features of a block from a lane on belong to a patch of a feature.
HWY_INLINE auto inSamePatch(const Feature& feature, std::size_t sets, const FeatureBlock& block, std::size_t lane) {
  const BoxFloats d;
  const hn::RebindToSigned<BoxFloats> di;
  auto same = hn::Lt(hn::Zero(d), hn::Zero(d));
  for (std::size_t k = 0; k < sets; ++k) {
    const std::int32_t patch = feature.block.patches[k][feature.lane];
    const auto theirs = hn::LoadU(di, block.patches[k].data() + lane);
    same = hn::Or(same, hn::RebindMask(d, hn::Eq(theirs, hn::Set(di, patch >= 0 ? patch : -2))));
  }
  return same;
}

/// Which features of a block from a lane on have a vertex in common with a feature.
HWY_INLINE auto withCommonVertex(const Feature& feature, const FeatureBlock& block, std::size_t lane) {
  const BoxFloats d;
  const hn::RebindToSigned<BoxFloats> di;
  auto common = hn::Lt(hn::Zero(d), hn::Zero(d));
  for (const auto& theirs : block.corners) {
    const auto vertices = hn::LoadU(di, theirs.data() + lane);
    for (const auto& own : feature.block.corners) {
      common = hn::Or(common, hn::RebindMask(d, hn::Eq(vertices, hn::Set(di, own[feature.lane]))));
    }
  }
  return common;
}

/// Calls take(feature, block, lane) for the features of a leaf that overlap a feature.
template <CommonVertices common, typename Take>
HWY_INLINE void forEachOverlapWith(const Feature& feature, std::span<const FeatureBlock> blocks, std::size_t sets,
                                   Take&& take) {
  const BoxFloats d;
  const LaneBox box = feature.box();
  for (const FeatureBlock& block : blocks) {
    for (std::size_t lane = 0; lane < blockLanes; lane += hn::Lanes(d)) {
      auto found = overlapping(box, block, lane);
      if (hn::AllFalse(d, found)) {
        continue;
      }
      found = hn::AndNot(inSamePatch(feature, sets, block, lane), found);
      if (common == CommonVertices::LeftOut) {
        found = hn::AndNot(withCommonVertex(feature, block, lane), found);
      }
      for (std::uint32_t bits = bitsOf(found); bits != 0; bits &= bits - 1) {
        take(feature, block, lane + static_cast<std::size_t>(std::countr_zero(bits)));
      }
    }
  }
}

/// A leaf of features.
struct Leaf {
  const FeatureBoxes& boxes;
  const FeatureBoxes::Leaf& leaf;

  [[nodiscard]] std::span<const FeatureBlock> blocks() const {
    return {boxes.blocks.data() + leaf.firstBlock, leaf.blocks};
  }
  /// Whether all features of the leaf belong to one patch.
  [[nodiscard]] bool isOfOnePatch() const {
    const auto used = std::span(leaf.patches).first(boxes.sets);
    return std::ranges::any_of(used, [](std::int32_t patch) { return patch >= 0; });
  }
};

/// Calls take(feature, block, lane) for the overlapping boxes of different patches.
template <CommonVertices common, typename Take>
HWY_INLINE void forEachOverlap(const Leaf& outer, const Leaf& inner, Take&& take) {
  const BoxFloats d;
  const std::size_t sets = outer.boxes.sets;
  for (const FeatureBlock& block : outer.blocks()) {
    for (std::size_t lane = 0; lane < blockLanes; lane += hn::Lanes(d)) {
      for (std::uint32_t near = bitsOf(overlapping(inner.leaf.box, block, lane)); near != 0; near &= near - 1) {
        const Feature feature{block, lane + static_cast<std::size_t>(std::countr_zero(near))};
        if (!feature.isInPatchOf(inner.leaf, sets)) {
          forEachOverlapWith<common>(feature, inner.blocks(), sets, take);
        }
      }
    }
  }
}

template <CommonVertices common>
HWY_INLINE void overlapsOf(const Leaf& one, const Leaf& other, std::vector<OverlappingBoxes>& found) {
  const auto add = [&](const Feature& feature, const FeatureBlock& block, std::size_t lane) {
    found.push_back({feature.block.features[feature.lane], block.features[lane]});
  };
  if (&one.leaf == &other.leaf) {
    forEachOverlap<common>(one, other, [&](const Feature& feature, const FeatureBlock& block, std::size_t lane) {
      if (&block > &feature.block || (&block == &feature.block && lane > feature.lane)) {
        add(feature, block, lane);
      }
    });
  } else if (one.isOfOnePatch() && !other.isOfOnePatch()) {
    // Features of the outer leaf are skipped if they belong to the patch of the whole inner leaf.
    forEachOverlap<common>(other, one, [&](const Feature& feature, const FeatureBlock& block, std::size_t lane) {
      found.push_back({block.features[lane], feature.block.features[feature.lane]});
    });
  } else {
    forEachOverlap<common>(one, other, add);
  }
}

void overlaps(const FeatureBoxes& first, std::size_t firstLeaf, const FeatureBoxes& second, std::size_t secondLeaf,
              CommonVertices common, std::vector<OverlappingBoxes>& found) {
  const Leaf one{first, first.leaves[firstLeaf]};
  const Leaf other{second, second.leaves[secondLeaf]};
  if (common == CommonVertices::LeftOut) {
    overlapsOf<CommonVertices::LeftOut>(one, other, found);
  } else {
    overlapsOf<CommonVertices::Permitted>(one, other, found);
  }
}

}  // namespace drape::sim::contact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::contact {

HWY_EXPORT(overlaps);

void findOverlaps(const FeatureBoxes& first, std::size_t firstLeaf, const FeatureBoxes& second, std::size_t secondLeaf,
                  CommonVertices common, std::vector<OverlappingBoxes>& found) {
  found.clear();
  HWY_DYNAMIC_DISPATCH(overlaps)(first, firstLeaf, second, secondLeaf, common, found);
}

}  // namespace drape::sim::contact
#endif
