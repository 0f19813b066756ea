#include "sim/model/seams.hpp"

#include "sim/model/disjoint_sets.hpp"

#include <algorithm>

namespace drape::sim {

bool isWelded(const Seam& seam, std::span<const Vec3> positions) {
  return std::ranges::all_of(seam.pairs, [&](const SeamPair& pair) { return positions[pair.a] == positions[pair.b]; });
}

std::vector<int> leadersOf(std::span<const Seam> seams, const std::vector<bool>& pinned) {
  DisjointSets sets(pinned.size());
  for (const Seam& seam : seams) {
    for (const SeamPair& pair : seam.pairs) {
      sets.join(pair.a, pair.b);
    }
  }
  std::vector<int> leaders(pinned.size());
  std::vector<int> pinOf(pinned.size(), -1);  // of each lowest vertex
  const int count = static_cast<int>(pinned.size());
  for (int v = 0; v < count; ++v) {
    leaders[v] = sets.root(v);
    if (pinned[v] && pinOf[leaders[v]] < 0) {
      pinOf[leaders[v]] = v;
    }
  }
  std::ranges::transform(leaders, leaders.begin(), [&](int root) { return pinOf[root] < 0 ? root : pinOf[root]; });
  return leaders;
}

}  // namespace drape::sim
