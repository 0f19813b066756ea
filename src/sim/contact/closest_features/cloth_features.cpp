#include "sim/contact/closest_features/cloth_features.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace drape {

std::vector<OwnedFeatures> ownedFeatures(const std::vector<Triangle>& triangles, int vertexCount) {
  std::vector<OwnedFeatures> owned(triangles.size());
  std::vector<bool> taken(static_cast<std::size_t>(vertexCount), false);
  std::vector<std::pair<std::uint64_t, std::size_t>> sides;  // the edge, and 3 * triangle + side
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<std::uint64_t>(triangles[t][k]);
      const auto b = static_cast<std::uint64_t>(triangles[t][(k + 1) % 3]);
      owned[t].corners[k] = !taken[a];
      taken[a] = true;
      sides.emplace_back((std::min(a, b) << 32U) | std::max(a, b), 3 * t + k);
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    owned[sides[i].second / 3].sides[sides[i].second % 3] = i == 0 || sides[i].first != sides[i - 1].first;
  }
  return owned;
}

}  // namespace drape
