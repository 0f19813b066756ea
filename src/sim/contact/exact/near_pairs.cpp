#include "sim/contact/exact/near_pairs.hpp"

namespace drape::sim::contact {
namespace {

/// Excess over the limit that covers the rounding of the measurement [-]. Limits are at least 1e-4 m, and the rounding
/// error is below 1e-15 of the size of the offsets and motions.
constexpr double measureRounding = 1e-3;

}  // namespace

bool staysApart(const Approach& approach, std::size_t i, double limit) {
  const double minimum = limit * (1.0 + measureRounding);
  return approach.start[i] >= minimum && approach.end[i] >= minimum;  // false for NaN
}

void NearPairs::measure(bool edges, Kind& kind, const PairFilter& filter) {
  const bool forContacts = filter.contactLimit > 0.0;
  if (forContacts) {
    measureContactGaps(edges, kind.lanes, filter.start.data(), filter.end.data(), kind.gaps);
  } else {
    measureApproach(edges, kind.lanes, filter.start.data(), filter.end.data(), kind.approach);
  }
  const double largest = filter.contactLimit * (1.0 + measureRounding);
  for (std::size_t i = 0; i < kind.indices.size(); ++i) {
    const bool isFar = forContacts ? kind.gaps[i] >= largest : staysApart(kind.approach, i, filter.limit);
    if (!isFar) {
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
