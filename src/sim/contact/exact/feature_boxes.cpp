#include "sim/contact/exact/feature_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape::sim::contact {
namespace {

constexpr float farAway = std::numeric_limits<float>::infinity();

/// Upper bound of the relative rounding error of a conversion to float.
constexpr float floatRounding = 1.2e-7F;

void endLeaf(FeatureBoxes& boxes) {
  boxes.count.push_back(static_cast<int>(boxes.features.size()) - boxes.begin.back());
  while (boxes.features.size() % maxLanes != 0) {
    boxes.features.push_back(-1);
  }
  boxes.begin.push_back(static_cast<int>(boxes.features.size()));
}

void endBoxes(FeatureBoxes& boxes) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    boxes.low[axis].assign(boxes.features.size(), farAway);
    boxes.high[axis].assign(boxes.features.size(), -farAway);
  }
  for (FeatureBoxes::Patches& patches : boxes.patches) {
    patches.ofFeature.assign(boxes.features.size(), -1);
    patches.ofLeaf.assign(boxes.count.size(), -1);
  }
}

void setBox(FeatureBoxes& boxes, std::size_t i, const Vec3& low, const Vec3& high) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto bottom = static_cast<float>(low[static_cast<Eigen::Index>(axis)]);
    const auto top = static_cast<float>(high[static_cast<Eigen::Index>(axis)]);
    boxes.low[axis][i] = bottom - std::abs(bottom) * floatRounding;
    boxes.high[axis][i] = top + std::abs(top) * floatRounding;
  }
}

/// @param labels the patch of each feature
void setPatchesOf(const FeatureBoxes& boxes, const std::vector<int>& labels, FeatureBoxes::Patches& patches) {
  for (std::size_t leaf = 0; leaf < boxes.count.size(); ++leaf) {
    const int begin = boxes.begin[leaf];
    const int end = begin + boxes.count[leaf];
    bool isPure = begin < end;
    for (int i = begin; i < end; ++i) {
      patches.ofFeature[i] = labels[boxes.features[i]];
      isPure = isPure && patches.ofFeature[i] == patches.ofFeature[begin];
    }
    patches.ofLeaf[leaf] = isPure ? patches.ofFeature[begin] : -1;
  }
}

}  // namespace

void LeafBoxes::setPatches(const FeaturePatches* patches) {
  sets_ = 0;
  while (patches != nullptr && sets_ < patchSets && (*patches)[sets_].patches->count() > 0) {
    const PatchLabels& labels = (*patches)[sets_];
    setPatchesOf(vertices_, labels.ofVertex, vertices_.patches[sets_]);
    setPatchesOf(edges_, labels.ofEdge, edges_.patches[sets_]);
    setPatchesOf(triangles_, labels.ofTriangle, triangles_.patches[sets_]);
    findPatchesOfLeaves(sets_);
    ++sets_;
  }
  for (FeatureBoxes* boxes : {&vertices_, &edges_, &triangles_}) {
    boxes->sets = sets_;
  }
}

/// Finds the common patch of the vertices, edges and triangles of each leaf. Each leaf has triangles.
void LeafBoxes::findPatchesOfLeaves(std::size_t set) {
  std::vector<int>& patches = patchesOfLeaves_[set];
  patches = triangles_.patches[set].ofLeaf;
  for (const FeatureBoxes* boxes : {&vertices_, &edges_}) {
    for (std::size_t leaf = 0; leaf < patches.size(); ++leaf) {
      const bool isSame = boxes->count[leaf] == 0 || boxes->patches[set].ofLeaf[leaf] == patches[leaf];
      patches[leaf] = isSame ? patches[leaf] : -1;
    }
  }
}

LeafBoxes::LeafBoxes(const FeatureMesh& mesh, const MeshTree& tree) {
  for (FeatureBoxes* boxes : {&vertices_, &edges_, &triangles_}) {
    boxes->begin.push_back(0);
  }
  for (std::size_t leaf = 0; leaf < tree.leafCount(); ++leaf) {
    for (const int t : tree.leaf(leaf)) {
      const FeatureMesh::Owned& owned = mesh.owned[t];
      triangles_.features.push_back(t);
      vertices_.features.insert(vertices_.features.end(), owned.vertices.begin(),
                                owned.vertices.begin() + owned.vertexCount);
      edges_.features.insert(edges_.features.end(), owned.edges.begin(), owned.edges.begin() + owned.edgeCount);
    }
    for (FeatureBoxes* boxes : {&vertices_, &edges_, &triangles_}) {
      endLeaf(*boxes);
    }
  }
  for (FeatureBoxes* boxes : {&vertices_, &edges_, &triangles_}) {
    endBoxes(*boxes);
  }
}

void LeafBoxes::fit(const FeatureMesh& mesh, std::span<const Vec3> low, std::span<const Vec3> high) {
  const Vec3 origin = low.empty() ? Vec3(Vec3::Zero()) : low[0];
  const auto fitAll = [&](FeatureBoxes& boxes, auto&& cornersOf) {
    for (std::size_t i = 0; i < boxes.features.size(); ++i) {
      if (boxes.features[i] >= 0) {
        const auto [bottom, top] = cornersOf(boxes.features[i]);
        setBox(boxes, i, bottom - origin, top - origin);
      }
    }
  };
  using LowAndHigh = std::pair<Vec3, Vec3>;
  fitAll(vertices_, [&](int v) { return LowAndHigh(low[v], high[v]); });
  fitAll(edges_, [&](int e) {
    const auto& [a, b] = mesh.edges.edges[e];
    return LowAndHigh(low[a].cwiseMin(low[b]), high[a].cwiseMax(high[b]));
  });
  fitAll(triangles_, [&](int t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return LowAndHigh(low[a].cwiseMin(low[b]).cwiseMin(low[c]), high[a].cwiseMax(high[b]).cwiseMax(high[c]));
  });
}

}  // namespace drape::sim::contact
