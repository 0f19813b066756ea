#include "sim/model/quantile.hpp"

#include <algorithm>

namespace drape::sim {

double quantileExceededBy(std::vector<double>& values, std::size_t oneIn) {
  if (values.empty()) {
    return 0.0;
  }
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() - 1 - (values.size() - 1) / oneIn);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace drape::sim
