#include "sim/contact/broad_phase/cloth_clusters.hpp"

#include "sim/contact/broad_phase/mesh_tree.hpp"

#include <algorithm>

namespace drape::sim::contact {
namespace {

constexpr std::size_t clusterSize = 8;  // triangles

}  // namespace

ClothClusters::ClothClusters(const ClothModel& model) {
  const MeshTree tree(model.restPositions, model.triangles, clusterSize);
  std::vector<bool> taken(model.restPositions.size(), false);
  std::vector<int> own;
  std::vector<int> others;
  for (std::size_t leaf = 0; leaf < tree.leafCount(); ++leaf) {
    own.clear();
    others.clear();
    for (const int t : tree.leaf(leaf)) {
      triangles_.push_back(t);
      for (const int v : model.triangles[t]) {
        std::vector<int>& list = taken[v] ? others : own;
        if (std::find(own.begin(), own.end(), v) == own.end() &&
            std::find(others.begin(), others.end(), v) == others.end()) {
          list.push_back(v);
        }
      }
    }
    vertices_.insert(vertices_.end(), own.begin(), own.end());
    ownEnd_.push_back(static_cast<int>(vertices_.size()));
    vertices_.insert(vertices_.end(), others.begin(), others.end());
    vertexBegin_.push_back(static_cast<int>(vertices_.size()));
    triangleBegin_.push_back(static_cast<int>(triangles_.size()));
    for (const int v : own) {
      taken[v] = true;
    }
  }
}

std::pair<std::size_t, std::size_t> ClothClusters::clustersWithin(int begin, int end) const {
  const auto first = triangleBegin_.begin();
  const auto last = triangleBegin_.end() - 1;
  return {static_cast<std::size_t>(std::lower_bound(first, last, begin) - first),
          static_cast<std::size_t>(std::lower_bound(first, last, end) - first)};
}

}  // namespace drape::sim::contact
