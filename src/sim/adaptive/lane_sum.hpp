#pragma once

#include "sim/simd/slice_layout.hpp"

#include <array>
#include <numeric>
#include <vector>

namespace drape {

/// The sum of the numbers of whole slices. One sum per lane: a single sum would wait for each addition.
template <typename T>
[[nodiscard]] double sumOfLanes(const std::vector<T>& values) {
  std::array<double, sliceLanes> lanes{};
  for (std::size_t i = 0; i < values.size(); i += sliceLanes) {
    for (std::size_t lane = 0; lane < sliceLanes; ++lane) {
      lanes[lane] += static_cast<double>(values[i + lane]);
    }
  }
  return std::accumulate(lanes.begin(), lanes.end(), 0.0);
}

}  // namespace drape
