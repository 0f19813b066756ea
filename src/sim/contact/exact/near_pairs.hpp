#pragma once

#include "sim/contact/constraints/collect_in_order.hpp"
#include "sim/contact/exact/pair_search.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// A step and the distance up to which pairs matter in it.
struct PairFilter {
  std::span<const Vec3> start;  ///< positions [m]
  std::span<const Vec3> end;    ///< positions [m]
  double limit = 0.0;           ///< [m]
  double contactLimit = 0.0;    ///< of measureContactGaps [m]; 0: pairs count that are no contacts too
};

/// Whether pair i certainly stays farther apart than a limit [m] in the whole step: it does so along one normal, at the
/// start and at the end.
[[nodiscard]] bool staysApart(const Approach& approach, std::size_t i, double limit);

/// Chooses the pairs of a search that may come closer than a limit: all but those that stay apart (staysApart), or
/// whose closest points do not come nearer than the limit for contacts, if there is one.
class NearPairs {
 public:
  /// Chooses among the listed pairs `begin` to `end` - 1. Ascending.
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
