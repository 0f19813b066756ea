#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace drape::io {

/// A hash table of the indices 0, 1, 2, ... whose keys the caller stores. It finds indices with equal hashes, and the
/// caller compares the keys. It consists of two flat arrays, so a million entries cost milliseconds.
class ChainedIndex {
 public:
  /// Reserves space for the indices 0 .. capacity - 1.
  explicit ChainedIndex(std::size_t capacity) : next_(capacity, none) {
    std::size_t buckets = 16;
    while (buckets < 2 * capacity) {
      buckets *= 2;
    }
    head_.assign(buckets, none);
  }

  static constexpr int none = -1;

  /// The first index with this hash (or with one of the same bucket), or `none`.
  [[nodiscard]] int first(std::uint64_t hash) const { return head_[bucketOf(hash)]; }

  /// The next index after `index`, or `none`.
  [[nodiscard]] int next(int index) const { return next_[index]; }

  /// Inserts a new index.
  void insert(std::uint64_t hash, int index) {
    int& head = head_[bucketOf(hash)];
    next_[index] = head;
    head = index;
  }

 private:
  [[nodiscard]] std::size_t bucketOf(std::uint64_t hash) const {
    return static_cast<std::size_t>(hash) & (head_.size() - 1);
  }

  std::vector<int> head_;
  std::vector<int> next_;
};

}  // namespace drape::io
