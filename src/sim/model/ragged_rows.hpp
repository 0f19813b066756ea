#pragma once

#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace drape::sim {

/// Rows of different length, stored one after the other. Access checks no index.
template <typename T>
class RaggedRows {
 public:
  RaggedRows() = default;

  /// Rows of these lengths, filled with T().
  explicit RaggedRows(std::span<const int> lengths) : begin_(beginsOf(lengths)), values_(begin_.back()) {}

  /// Rows of these lengths with these values, row by row. The sum of the lengths must be the number of values.
  RaggedRows(std::span<const int> lengths, std::vector<T> values)
      : begin_(beginsOf(lengths)), values_(std::move(values)) {}

  /// Collects pairs (row, value). A row has its values in the order of the calls. `forEach` is called twice; it must
  /// call its argument with the same pairs in the same order.
  template <typename ForEach>
  static RaggedRows collect(std::size_t rowCount, const ForEach& forEach) {
    std::vector<int> lengths(rowCount, 0);
    forEach([&](std::size_t row, const T&) { ++lengths[row]; });
    RaggedRows rows(lengths);
    std::vector<int> next(rows.begin_.begin(), rows.begin_.end() - 1);
    forEach([&](std::size_t row, const T& value) { rows.values_[next[row]++] = value; });
    return rows;
  }

  [[nodiscard]] std::size_t rowCount() const { return begin_.empty() ? 0 : begin_.size() - 1; }

  [[nodiscard]] std::span<const T> operator[](std::size_t row) const {
    return {values_.data() + begin_[row], values_.data() + begin_[row + 1]};
  }
  [[nodiscard]] std::span<T> operator[](std::size_t row) {
    return {values_.data() + begin_[row], values_.data() + begin_[row + 1]};
  }

  /// The values of all rows, row by row.
  [[nodiscard]] const std::vector<T>& values() const { return values_; }

 private:
  static std::vector<int> beginsOf(std::span<const int> lengths) {
    std::vector<int> begins(lengths.size() + 1, 0);
    std::partial_sum(lengths.begin(), lengths.end(), begins.begin() + 1);
    return begins;
  }

  std::vector<int> begin_;  // row i is values_[begin_[i]] .. values_[begin_[i + 1] - 1]; empty without rows
  std::vector<T> values_;
};

/// The indices of each row, ascending. `rowOf` has the row of each index.
[[nodiscard]] inline RaggedRows<int> indicesByRow(std::span<const int> rowOf, std::size_t rowCount) {
  return RaggedRows<int>::collect(rowCount, [&](const auto& add) {
    for (std::size_t i = 0; i < rowOf.size(); ++i) {
      add(rowOf[i], static_cast<int>(i));
    }
  });
}

}  // namespace drape::sim
