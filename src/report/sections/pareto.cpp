#include "report/sections/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape::report::sections {

std::vector<std::size_t> paretoFront(std::span<const CostAndError> entries) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (std::isfinite(entries[i].cost) && std::isfinite(entries[i].error)) {
      order.push_back(i);
    }
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return entries[a].cost != entries[b].cost ? entries[a].cost < entries[b].cost : entries[a].error < entries[b].error;
  });
  std::vector<std::size_t> front;
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (entries[i].error < best) {
      best = entries[i].error;
      front.push_back(i);
    }
  }
  return front;
}

}  // namespace drape::report::sections
