#pragma once

#include "sim/model/workers.hpp"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace drape::sim::contact {

/// Divides the range 0 to count - 1 among threads and calls visit(begin, end, found) for each part, each with its own
/// `Found`. Returns these in the order of the parts, so that the result does not depend on the threads.
template <typename Found, typename Visit>
[[nodiscard]] std::vector<Found> collectInOrder(Workers& workers, int threads, int count, Visit&& visit) {
  std::mutex mutex;
  std::vector<std::pair<int, Found>> parts;
  workers.forRange(threads, count, [&](int begin, int end) {
    Found found;
    visit(begin, end, found);
    const std::lock_guard lock(mutex);
    parts.emplace_back(begin, std::move(found));
  });
  std::sort(parts.begin(), parts.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  std::vector<Found> all;
  for (auto& [begin, found] : parts) {
    all.push_back(std::move(found));
  }
  return all;
}

}  // namespace drape::sim::contact
