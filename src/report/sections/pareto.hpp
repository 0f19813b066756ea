#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace drape::report::sections {

struct CostAndError {
  double cost = 0.0;
  double error = 0.0;
};

/// The Pareto-optimal entries in cost and error, by ascending cost. Entries that are not finite are never optimal.
[[nodiscard]] std::vector<std::size_t> paretoFront(std::span<const CostAndError> entries);

}  // namespace drape::report::sections
