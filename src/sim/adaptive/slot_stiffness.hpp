#pragma once

#include "sim/simd/sliced_cloth.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace drape::sim::adaptive {

/// Computes one number for each slot and lane: `ofRate(rate)` with the larger rate of the spring's two ends, 0 in lanes
/// without a spring. Returns the smallest value of a spring.
/// @param rates omega_i^2 / k [1/kg], one a vertex of the model in its own order
template <typename T, typename OfRate>
double fillSlots(const simd::SlicedCloth<T>& cloth, const std::vector<double>& rates, OfRate&& ofRate,
                 std::vector<simd::SliceNumbers<T>>& slots) {
  const simd::SliceLayout& layout = cloth.layout;
  const auto rateAt = [&](int index) { return rates[layout.order[index]]; };
  slots.assign(layout.slots.size(), {});
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t slice = 0; slice + 1 < layout.slotBegin.size(); ++slice) {
    for (int s = layout.slotBegin[slice]; s < layout.slotBegin[slice + 1]; ++s) {
      const simd::SliceLayout::Slot& slot = layout.slots[s];
      for (std::size_t lane = 0; lane < simd::sliceLanes; ++lane) {
        if (cloth.restLength[s][lane] < T(0)) {
          continue;
        }
        const int neighbour =
            slot.table < 0 ? slot.first + static_cast<int>(lane) : layout.neighbourTables[slot.table][lane];
        const double value =
            ofRate(std::max(rateAt(static_cast<int>(slice * simd::sliceLanes + lane)), rateAt(neighbour)));
        smallest = std::min(smallest, value);
        slots[s][lane] = static_cast<T>(value);
      }
    }
  }
  return smallest;
}

}  // namespace drape::sim::adaptive
