#pragma once

#include "sim/contact/constraints/collect_in_order.hpp"
#include "sim/contact/exact/pair_search.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// A step and the distance up to which pairs matter in it.
struct PairFilter {
  std::span<const Vec3> start;  ///< positions at its start [m]
  std::span<const Vec3> end;    ///< positions at its end [m]
  double limit = 0.0;           ///< pairs that stay farther apart do not matter [m]
  double contactLimit = 0.0;    ///< limit of measureContactGaps [m]; 0: pairs that are no contacts matter too
};

/// Whether pair i certainly stays farther apart than a limit [m] in the whole step: along one normal it is farther
/// apart at the start and at the end, and so in between.
[[nodiscard]] bool staysApart(const Approach& approach, std::size_t i, double limit);

/// Chooses the pairs of a search that may come closer than the limit of a filter. Without a limit for contacts these
/// are all pairs except those that stay apart (staysApart). With one, these are all pairs except those whose closest
/// points do not come nearer than it (measureContactGaps).
class NearPairs {
 public:
  /// The indices of the chosen ones among the listed pairs `begin` to `end` - 1, ascending. Valid until the next call.
  [[nodiscard]] std::span<const int> choose(const PairSearch& search, const PairFilter& filter, int begin, int end);

 private:
  struct Kind {
    std::vector<int> indices;
    PairLanes lanes;
    Approach approach;
    std::vector<double> gaps;
  };

  void measure(bool edges, Kind& kind, const PairFilter& filter);

  Kind vertices_, edges_;
  std::vector<int> chosen_;
};

/// Calls visit(pair, found) for the chosen pairs, and appends all elements to `all` in the order of the list.
template <typename T, typename Visit>
void collectFromNearPairs(const PairSearch& search, const PairFilter& filter, Workers& workers, int threads,
                          std::vector<T>& all, Visit&& visit) {
  constexpr int blockSize = 512;
  const int count = static_cast<int>(search.pairs().size());
  const auto parts = collectInOrder<std::vector<T>>(
      workers, threads, (count + blockSize - 1) / blockSize, [&](int begin, int end, std::vector<T>& found) {
        NearPairs near;
        for (int block = begin; block < end; ++block) {
          const int first = block * blockSize;
          for (const int i : near.choose(search, filter, first, std::min(first + blockSize, count))) {
            visit(search.pairs()[i].pair, found);
          }
        }
      });
  for (const std::vector<T>& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
  }
}

}  // namespace drape::sim::contact
