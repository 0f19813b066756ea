#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace drape::sim {

/// A disjoint-set forest (union-find). Each set is represented by its lowest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  [[nodiscard]] std::size_t size() const { return parent_.size(); }

  int root(int item) {
    while (parent_[item] != item) {
      parent_[item] = parent_[parent_[item]];
      item = parent_[item];
    }
    return item;
  }

  /// Merges the sets of two items. True if they were different before.
  bool join(int a, int b) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    parent_[high] = low;
    return low != high;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace drape::sim
