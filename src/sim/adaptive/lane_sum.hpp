#pragma once

#include "sim/simd/slice_layout.hpp"

#include <array>
#include <numeric>
#include <vector>

namespace drape::sim::adaptive {

/// The sum of the numbers of whole slices. One sum per lane, since each addition to a single sum waits for the one
/// before.
template <typename T>
[[nodiscard]] double sumOfLanes(const std::vector<T>& values) {
  std::array<double, simd::sliceLanes> lanes{};
  for (std::size_t i = 0; i < values.size(); i += simd::sliceLanes) {
    for (std::size_t lane = 0; lane < simd::sliceLanes; ++lane) {
      lanes[lane] += static_cast<double>(values[i + lane]);
    }
  }
  return std::accumulate(lanes.begin(), lanes.end(), 0.0);
}

}  // namespace drape::sim::adaptive
