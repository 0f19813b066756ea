#pragma once

#include "sim/contact/broad_phase/mesh_tree.hpp"
#include "sim/contact/exact/feature_patches.hpp"
#include "sim/contact/self/float_lanes.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// The bounding boxes and patches of the features of one kind, leaf after leaf of a tree, one array per coordinate.
/// Each leaf is padded to whole vectors by empty boxes.
struct FeatureBoxes {
  /// The patches of a set.
  struct Patches {
    std::vector<std::int32_t> ofFeature;  ///< see FeaturePatches
    std::vector<std::int32_t> ofLeaf;     ///< the common patch of all features of a leaf; -1: there is none
  };

  std::vector<std::int32_t> features;      ///< index of the vertex, edge or triangle; -1: padding
  std::array<Patches, patchSets> patches;  ///< for each set of patches
  std::size_t sets = 0;                    ///< number of sets that have patches; the first ones
  std::vector<int> begin;                  ///< first feature of each leaf, and one past the last
  std::vector<int> count;                  ///< number of features of each leaf, without padding
  std::array<std::vector<float>, 3> low;   ///< relative to an origin, rounded down [m]
  std::array<std::vector<float>, 3> high;  ///< rounded up [m]
};

/// The boxes of the vertices, edges and triangles of a cloth in the leaves of a tree. A vertex or an edge of several
/// triangles is in the leaf of the triangle that owns it.
class LeafBoxes {
 public:
  LeafBoxes(const FeatureMesh& mesh, const MeshTree& tree);

  /// Fits the boxes to those of the vertices.
  /// @param low, high corners of the box of each vertex [m]
  void fit(const FeatureMesh& mesh, std::span<const Vec3> low, std::span<const Vec3> high);

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
  void findPatchesOfLeaves(std::size_t set);

  FeatureBoxes vertices_, edges_, triangles_;
  std::array<std::vector<int>, patchSets> patchesOfLeaves_;
  std::size_t sets_ = 0;
};

/// Two features whose boxes overlap.
struct OverlappingBoxes {
  std::int32_t first = 0;
  std::int32_t second = 0;
};

/// Finds the pairs of a feature of one leaf and a feature of another whose boxes overlap, except pairs of one patch. If
/// both are the same boxes and the same leaf, each pair is found once. The order depends only on the leaves and the
/// patches. Uses the widest vector instructions of the machine; the result is the same with any instruction set.
/// @param found replaced
void findOverlaps(const FeatureBoxes& first, std::size_t firstLeaf, const FeatureBoxes& second, std::size_t secondLeaf,
                  std::vector<OverlappingBoxes>& found);

}  // namespace drape::sim::contact
