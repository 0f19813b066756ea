#pragma once

#include "sim/simd/sliced_cloth.hpp"

#include <algorithm>
#include <vector>

namespace drape::sim::simd {

/// Number of aggregates that are summed together.
inline constexpr std::size_t aggregatesPerBatch = 4;

/// The members of aggregates and their weights in the mean. All aggregates of a batch have the same number of members:
/// shorter lists are filled with members of weight 0, so that no branch depends on the number.
template <typename T>
struct AggregateMembers {
  std::vector<int> begin;    ///< the first row of each batch; one more at the end
  std::vector<int> indices;  ///< permuted indices; a row has one member of each aggregate of the batch
  std::vector<T> weights;    ///< as `indices`; they sum to 1 in each aggregate [-]
  std::vector<T> positions;  ///< scratch memory: 4 numbers for each lane of the members' slices

  /// @param members of each aggregate, permuted indices  @param weightOf(aggregate, index) of a member [-]
  /// @param room number of lanes in the members' slices
  template <typename WeightOf>
  void fill(const std::vector<std::vector<int>>& members, WeightOf&& weightOf, std::size_t room);
};

/// Computes the position of each aggregate, the mean of its members.
/// @param from positions of the members [m]  @param means receives the positions of the aggregates [m]
void gatherMeans(const LaneVectors<float>& from, AggregateMembers<float>& aggregates, LaneVectors<float>& means);
void gatherMeans(const LaneVectors<double>& from, AggregateMembers<double>& aggregates, LaneVectors<double>& means);

template <typename T>
template <typename WeightOf>
void AggregateMembers<T>::fill(const std::vector<std::vector<int>>& members, WeightOf&& weightOf, std::size_t room) {
  begin.push_back(0);
  for (std::size_t first = 0; first < members.size(); first += aggregatesPerBatch) {
    const std::size_t end = std::min(first + aggregatesPerBatch, members.size());
    std::size_t rows = 0;
    for (std::size_t aggregate = first; aggregate < end; ++aggregate) {
      rows = std::max(rows, members[aggregate].size());
    }
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t aggregate = first; aggregate < first + aggregatesPerBatch; ++aggregate) {
        const bool present = aggregate < end && row < members[aggregate].size();
        indices.push_back(present ? members[aggregate][row] : 0);
        weights.push_back(present ? static_cast<T>(weightOf(aggregate, members[aggregate][row])) : T(0));
      }
    }
    begin.push_back(static_cast<int>(indices.size() / aggregatesPerBatch));
  }
  positions.assign(4 * room, T(0));
}

}  // namespace drape::sim::simd
