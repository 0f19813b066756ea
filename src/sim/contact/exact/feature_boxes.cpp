#include "sim/contact/exact/feature_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape::sim::contact {
namespace {

constexpr float farAway = std::numeric_limits<float>::infinity();

/// Upper bound of the relative rounding error of a conversion to float.
constexpr float floatRounding = 1.2e-7F;

void addBlock(FeatureBoxes& boxes) {
  FeatureBlock& block = boxes.blocks.emplace_back();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    block.low[axis].fill(farAway);
    block.high[axis].fill(-farAway);
    block.corners[axis].fill(-1);
  }
  block.features.fill(-1);
  for (auto& patches : block.patches) {
    patches.fill(-1);
  }
}

void addLeaf(FeatureBoxes& boxes) {
  FeatureBoxes::Leaf& leaf = boxes.leaves.emplace_back();
  leaf.firstBlock = boxes.blocks.size();
  leaf.patches.fill(-1);
}

/// Adds a feature to the last leaf.
void addFeature(int feature, const std::array<int, 3>& corners, FeatureBoxes& boxes) {
  FeatureBoxes::Leaf& leaf = boxes.leaves.back();
  const std::size_t lane = leaf.features++ % blockLanes;
  if (lane == 0) {
    addBlock(boxes);
    ++leaf.blocks;
  }
  FeatureBlock& block = boxes.blocks.back();
  block.features[lane] = feature;
  for (std::size_t k = 0; k < 3; ++k) {
    block.corners[k][lane] = corners[k];
  }
}

/// @param labels the patch of each feature
void setPatchesOf(FeatureBoxes& boxes, std::size_t set, const std::vector<int>& labels) {
  for (FeatureBoxes::Leaf& leaf : boxes.leaves) {
    bool isPure = leaf.features > 0;
    const int first = isPure ? labels[boxes.blocks[leaf.firstBlock].features[0]] : -1;
    forEachFeature(boxes, leaf, [&](FeatureBlock& block, std::size_t lane) {
      const int patch = labels[block.features[lane]];
      block.patches[set][lane] = patch;
      isPure = isPure && patch == first;
    });
    leaf.patches[set] = isPure ? first : -1;
  }
}

}  // namespace

void LeafBoxes::setPatches(const FeaturePatches* patches) {
  sets_ = 0;
  while (patches != nullptr && sets_ < patchSets && (*patches)[sets_].patches->count() > 0) {
    const PatchLabels& labels = (*patches)[sets_];
    setPatchesOf(vertices_, sets_, labels.ofVertex);
    setPatchesOf(edges_, sets_, labels.ofEdge);
    setPatchesOf(triangles_, sets_, labels.ofTriangle);
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
  patches.resize(triangles_.leaves.size());
  for (std::size_t leaf = 0; leaf < patches.size(); ++leaf) {
    const int patch = triangles_.leaves[leaf].patches[set];
    const auto agrees = [&](const FeatureBoxes::Leaf& each) {
      return each.features == 0 || each.patches[set] == patch;
    };
    patches[leaf] = agrees(vertices_.leaves[leaf]) && agrees(edges_.leaves[leaf]) ? patch : -1;
  }
}

LeafBoxes::LeafBoxes(const FeatureMesh& mesh, const MeshTree& tree) {
  for (std::size_t leaf = 0; leaf < tree.leafCount(); ++leaf) {
    for (FeatureBoxes* boxes : {&vertices_, &edges_, &triangles_}) {
      addLeaf(*boxes);
    }
    for (const int t : tree.leaf(leaf)) {
      const FeatureMesh::Owned& owned = mesh.owned[t];
      addFeature(t, mesh.triangles[t], triangles_);
      for (const int v : std::span(owned.vertices).first(owned.vertexCount)) {
        addFeature(v, {v, v, v}, vertices_);
      }
      for (const int e : std::span(owned.edges).first(owned.edgeCount)) {
        const auto& [a, b] = mesh.edges.edges[e];
        addFeature(e, {a, b, b}, edges_);
      }
    }
  }
  for (FeatureBoxes* boxes : {&vertices_, &edges_, &triangles_}) {
    boxes->blocks.shrink_to_fit();
  }
}

void LeafBoxes::fit(std::span<const Vec3> low, std::span<const Vec3> high) {
  const Vec3 origin = low.empty() ? Vec3(Vec3::Zero()) : low[0];
  sides_.resize(low.size());
  for (std::size_t v = 0; v < low.size(); ++v) {
    const Eigen::Vector3f bottom = (low[v] - origin).cast<float>();
    const Eigen::Vector3f top = (high[v] - origin).cast<float>();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      sides_[v][axis] = bottom[i] - std::abs(bottom[i]) * floatRounding;
      sides_[v][axis + 4] = -(top[i] + std::abs(top[i]) * floatRounding);
    }
  }
  for (FeatureBoxes* boxes : {&vertices_, &edges_, &triangles_}) {
    fitBoxes(*boxes);
  }
}

/// Fits the boxes of features, and those of leaves, to the boxes of the vertices.
void LeafBoxes::fitBoxes(FeatureBoxes& boxes) const {
  const auto extend = [](BoxSides& sides, const BoxSides& other) {
    for (std::size_t k = 0; k < sides.size(); ++k) {
      sides[k] = other[k] < sides[k] ? other[k] : sides[k];
    }
  };
  for (FeatureBoxes::Leaf& leaf : boxes.leaves) {
    BoxSides all;
    all.fill(farAway);
    forEachFeature(boxes, leaf, [&](FeatureBlock& block, std::size_t lane) {
      BoxSides sides = sides_[block.corners[0][lane]];
      extend(sides, sides_[block.corners[1][lane]]);
      extend(sides, sides_[block.corners[2][lane]]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        block.low[axis][lane] = sides[axis];
        block.high[axis][lane] = -sides[axis + 4];
      }
      extend(all, sides);
    });
    leaf.box = {{all[0], all[1], all[2]}, {-all[4], -all[5], -all[6]}};
  }
}

}  // namespace drape::sim::contact
