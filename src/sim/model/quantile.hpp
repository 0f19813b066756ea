#pragma once

#include <cstddef>
#include <vector>

namespace drape::sim {

/// The largest value that at most one in `oneIn` values exceeds; 0 if there are no values. Reorders the values.
[[nodiscard]] double quantileExceededBy(std::vector<double>& values, std::size_t oneIn);

}  // namespace drape::sim
