#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace drape {

struct CostAndError {
  double cost = 0.0;
  double error = 0.0;
};

/// The entries than which no other is both at most as costly and at most as wrong (and not the same in both), by
/// ascending cost. Entries that are not finite are on no front.
[[nodiscard]] std::vector<std::size_t> paretoFront(std::span<const CostAndError> entries);

}  // namespace drape
