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
  boxes.patches.assign(boxes.features.size(), -1);
  boxes.patchOfLeaf.assign(boxes.count.size(), -1);
}

void setBox(FeatureBoxes& boxes, std::size_t i, const Vec3& low, const Vec3& high) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto bottom = static_cast<float>(low[static_cast<Eigen::Index>(axis)]);
    const auto top = static_cast<float>(high[static_cast<Eigen::Index>(axis)]);
    boxes.low[axis][i] = bottom - std::abs(bottom) * floatRounding;
    boxes.high[axis][i] = top + std::abs(top) * floatRounding;
  }
}

void setPatchesOf(FeatureBoxes& boxes, const std::vector<int>* patches) {
  for (std::size_t leaf = 0; leaf < boxes.count.size(); ++leaf) {
    const int begin = boxes.begin[leaf];
    const int end = begin + boxes.count[leaf];
    bool isPure = begin < end;
    for (int i = begin; i < end; ++i) {
      boxes.patches[i] = patches != nullptr ? (*patches)[boxes.features[i]] : -1;
      isPure = isPure && boxes.patches[i] == boxes.patches[begin];
    }
    boxes.patchOfLeaf[leaf] = isPure ? boxes.patches[begin] : -1;
  }
}

}  // namespace

void LeafBoxes::setPatches(const FeaturePatches* patches) {
  setPatchesOf(vertices_, patches != nullptr ? &patches->ofVertex : nullptr);
  setPatchesOf(edges_, patches != nullptr ? &patches->ofEdge : nullptr);
  setPatchesOf(triangles_, patches != nullptr ? &patches->ofTriangle : nullptr);
}

bool LeafBoxes::areInOnePatch(std::size_t first, std::size_t second) const {
  const int patch = triangles_.patchOfLeaf[first];
  const auto isOfPatch = [&](const FeatureBoxes& boxes, std::size_t leaf) {
    return boxes.count[leaf] == 0 || boxes.patchOfLeaf[leaf] == patch;
  };
  return patch >= 0 && isOfPatch(triangles_, second) && isOfPatch(vertices_, first) && isOfPatch(vertices_, second) &&
         isOfPatch(edges_, first) && isOfPatch(edges_, second);
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
