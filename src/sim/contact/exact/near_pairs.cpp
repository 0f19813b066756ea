#include "sim/contact/exact/near_pairs.hpp"

namespace drape::sim::contact {
namespace {

/// Excess over the limit that covers the rounding of the measurement [-].
constexpr double measureRounding = 1e-3;

}  // namespace

void NearPairs::measure(bool edges, Kind& kind, const PairFilter& filter) {
  measureApproach(edges, kind.lanes, filter.start.data(), filter.end.data(), kind.approach);
  const double limit = filter.limit * (1.0 + measureRounding);
  for (std::size_t i = 0; i < kind.indices.size(); ++i) {
    // The negated comparison chooses NaN too.
    if (!(std::min(kind.approach.distance[i], kind.approach.separation[i]) >= limit)) {
      chosen_.push_back(kind.indices[i]);
    }
  }
}

std::span<const int> NearPairs::choose(const PairSearch& search, const PairFilter& filter, int begin, int end) {
  for (Kind* kind : {&vertices_, &edges_}) {
    kind->indices.clear();
    kind->lanes.clear();
  }
  chosen_.clear();
  for (int i = begin; i < end; ++i) {
    const PairSearch::Listed& listed = search.pairs()[i];
    if (search.minDistance(listed) < filter.limit) {
      Kind& kind = listed.pair.edges ? edges_ : vertices_;
      kind.indices.push_back(i);
      kind.lanes.add(verticesOf(search.mesh(), listed.pair).all);
    }
  }
  measure(false, vertices_, filter);
  const auto middle = static_cast<std::ptrdiff_t>(chosen_.size());
  measure(true, edges_, filter);
  std::inplace_merge(chosen_.begin(), chosen_.begin() + middle, chosen_.end());
  return chosen_;
}

}  // namespace drape::sim::contact
