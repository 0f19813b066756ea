#pragma once

#include "sim/contact/broad_phase/mesh_tree.hpp"
#include "sim/contact/exact/feature_patches.hpp"
#include "sim/contact/self/float_lanes.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// Number of features in a block. The triangles of a leaf fill one block.
inline constexpr int blockLanes = 8;

/// A vector of features of one kind. Entries without a feature have an empty box, which overlaps no other box.
struct FeatureBlock {
  template <typename T>
  using Lanes = std::array<T, blockLanes>;

  std::array<Lanes<float>, 3> low;   ///< of the bounding boxes, relative to an origin, rounded down [m]
  std::array<Lanes<float>, 3> high;  ///< rounded up [m]
  Lanes<std::int32_t> features;      ///< index of the vertex, edge or triangle
  /// The vertices of each feature, with repetition if it has fewer than three.
  std::array<Lanes<std::int32_t>, 3> corners;
  std::array<Lanes<std::int32_t>, patchSets> patches;  ///< of each set, see FeaturePatches
};

/// The bounding boxes and patches of the features of one kind, leaf after leaf of a tree.
struct FeatureBoxes {
  struct Leaf {
    std::size_t firstBlock = 0;
    std::size_t blocks = 0;
    std::size_t features = 0;
    LaneBox box;  ///< around the boxes of its features [m]
    /// The common patch of all features of the leaf, for each set; -1: there is none.
    std::array<std::int32_t, patchSets> patches{};
  };

  std::vector<FeatureBlock> blocks;
  std::vector<Leaf> leaves;
  std::size_t sets = 0;  ///< number of sets that have patches; the first ones
};

/// Calls visit(block, lane) for the features of a leaf.
template <typename Boxes, typename Visit>
void forEachFeature(Boxes& boxes, const FeatureBoxes::Leaf& leaf, Visit&& visit) {
  for (std::size_t i = 0; i < leaf.features; ++i) {
    visit(boxes.blocks[leaf.firstBlock + i / blockLanes], i % blockLanes);
  }
}

/// The boxes of the vertices, edges and triangles of a cloth in the leaves of a tree. A vertex or an edge of several
/// triangles is in the leaf of the triangle that owns it.
class LeafBoxes {
 public:
  LeafBoxes(const FeatureMesh& mesh, const MeshTree& tree);

  /// Fits the boxes to those of the vertices.
  /// @param low, high corners of the box of each vertex of the mesh [m]
  void fit(std::span<const Vec3> low, std::span<const Vec3> high);

  /// Stores the patches of the features. @param patches null: the features belong to no patch
  void setPatches(const FeaturePatches* patches);

  /// The number of sets that have patches.
  [[nodiscard]] std::size_t sets() const { return sets_; }

  /// The common patch of all features of each leaf, for a set that has patches; -1: there is none.
  [[nodiscard]] const std::vector<int>& patchesOfLeaves(std::size_t set) const { return patchesOfLeaves_[set]; }

  [[nodiscard]] const FeatureBoxes& vertices() const { return vertices_; }
  [[nodiscard]] const FeatureBoxes& edges() const { return edges_; }
  [[nodiscard]] const FeatureBoxes& triangles() const { return triangles_; }

 private:
  /// A box as the low coordinates, 0, the negatives of the high ones, and 0 [m]. The smaller of two numbers in each
  /// place gives the box around both.
  using BoxSides = std::array<float, 8>;

  void fitBoxes(FeatureBoxes& boxes) const;
  void findPatchesOfLeaves(std::size_t set);

  FeatureBoxes vertices_, edges_, triangles_;
  std::vector<BoxSides> sides_;  // of the boxes of the vertices
  std::array<std::vector<int>, patchSets> patchesOfLeaves_;
  std::size_t sets_ = 0;
};

/// Two features whose boxes overlap.
struct OverlappingBoxes {
  std::int32_t first = 0;
  std::int32_t second = 0;
};

/// Whether features that have a vertex in common count as overlapping.
enum class CommonVertices { Permitted, LeftOut };

/// Finds the pairs of a feature of one leaf and a feature of another whose boxes overlap, except pairs of one patch. If
/// both are the same boxes and the same leaf, each pair is found once. The order depends only on the leaves and the
/// patches. Uses the widest vector instructions of the machine; the result is the same with any instruction set.
/// @param found replaced
void findOverlaps(const FeatureBoxes& first, std::size_t firstLeaf, const FeatureBoxes& second, std::size_t secondLeaf,
                  CommonVertices common, std::vector<OverlappingBoxes>& found);

}  // namespace drape::sim::contact
