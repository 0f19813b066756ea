#pragma once

#include "sim/simd/sliced_cloth.hpp"

#include <algorithm>
#include <vector>

namespace drape {

/// So many groups are summed up together.
inline constexpr std::size_t groupsTogether = 4;

/// The members of groups and their weights in the group's mean. Groups that are summed up together have equally many
/// members: where one has fewer, the rest weighs nothing, so that no branch depends on how many it has.
template <typename T>
struct GroupMembers {
  std::vector<int> begin;    ///< for every `groupsTogether` groups their first round; one more at the end
  std::vector<int> places;   ///< round by round one member of each of the groups
  std::vector<T> weights;    ///< they sum to 1 in each group [-]
  std::vector<T> positions;  ///< room for 4 numbers a place of the members, a whole number of slices

  /// @param members of each group  @param weightOf(group, place) of a member [-]
  /// @param room places of the members, a whole number of slices
  template <typename WeightOf>
  void fill(const std::vector<std::vector<int>>& members, WeightOf&& weightOf, std::size_t room);
};

/// Puts each group where its members' mean is.
/// @param from the members' positions [m]  @param means takes those of the groups [m]
void gatherMeans(const LaneVectors<float>& from, GroupMembers<float>& groups, LaneVectors<float>& means);
void gatherMeans(const LaneVectors<double>& from, GroupMembers<double>& groups, LaneVectors<double>& means);

template <typename T>
template <typename WeightOf>
void GroupMembers<T>::fill(const std::vector<std::vector<int>>& members, WeightOf&& weightOf, std::size_t room) {
  begin.push_back(0);
  for (std::size_t first = 0; first < members.size(); first += groupsTogether) {
    const std::size_t end = std::min(first + groupsTogether, members.size());
    std::size_t most = 0;
    for (std::size_t group = first; group < end; ++group) {
      most = std::max(most, members[group].size());
    }
    for (std::size_t round = 0; round < most; ++round) {
      for (std::size_t group = first; group < first + groupsTogether; ++group) {
        const bool there = group < end && round < members[group].size();
        places.push_back(there ? members[group][round] : 0);
        weights.push_back(there ? static_cast<T>(weightOf(group, members[group][round])) : T(0));
      }
    }
    begin.push_back(static_cast<int>(places.size() / groupsTogether));
  }
  positions.assign(4 * room, T(0));
}

}  // namespace drape
