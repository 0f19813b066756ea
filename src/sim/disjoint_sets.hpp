#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace drape {

/// A disjoint-set forest (union-find). Each set is represented by its lowest member.
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int root(int item) {
    while (parentOf(item) != item) {
      parentOf(item) = parentOf(parentOf(item));
      item = parentOf(item);
    }
    return item;
  }

  /// Merges the sets of two items. True if they were different before.
  bool join(int a, int b) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    parentOf(high) = low;
    return low != high;
  }

 private:
  int& parentOf(int item) { return parent_[static_cast<std::size_t>(item)]; }

  std::vector<int> parent_;
};

}  // namespace drape
