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
  workers.forUnevenRange(threads, count, [&](int begin, int end) {
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

/// The same for vectors: calls visit(i, found) for each index and stores all elements in `all`, in the order of the
/// indices.
template <typename T, typename Visit>
void collectInOrder(Workers& workers, int threads, int count, std::vector<T>& all, Visit&& visit) {
  const auto parts =
      collectInOrder<std::vector<T>>(workers, threads, count, [&](int begin, int end, std::vector<T>& found) {
        for (int i = begin; i < end; ++i) {
          visit(i, found);
        }
      });
  for (const std::vector<T>& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
  }
}

}  // namespace drape::sim::contact
