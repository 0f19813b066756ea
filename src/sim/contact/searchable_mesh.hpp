#pragma once

#include "sim/contact/body.hpp"
#include "sim/contact/cloth_features.hpp"
#include "sim/contact/mesh_lanes.hpp"
#include "sim/contact/mesh_tree.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace drape {

/// A mesh with what is worked out of it for the search: once, and for one that moves in itself at every step.
class SearchableMesh {
 public:
  explicit SearchableMesh(MeshShape mesh);

  /// Follows a mesh that moves in itself: its vertices when the step begins and when it ends [m].
  void follow(std::span<const Vec3> before, std::span<const Vec3> after);

  [[nodiscard]] bool movesInItself() const { return shape.frames.size() > 1; }

  /// The extents of some leaves of the tree along a unit vector; as they are when the step ends, or when it begins.
  /// @return that of all together
  Extent extentsAlong(const Vec3& direction, const std::vector<std::int32_t>& leaves, bool atEnd,
                      std::vector<Extent>& extents) const {
    return drape::extentsAlong(lanes(atEnd), patchBegin_, leaves, direction, extents);
  }

  /// The boxes around the triangles of each leaf, triangle i of the leaf in lane i.
  [[nodiscard]] const std::vector<TriangleBoxes>& triangleBoxes(bool atEnd) const {
    return atEnd && movesInItself() ? endBoxes_ : startBoxes_;
  }

  /// Which triangles of a leaf reach into the slab between two heights along a unit vector, triangle i in bit i.
  [[nodiscard]] std::uint32_t trianglesBetween(const Vec3& direction, double low, double high, std::size_t leaf,
                                               bool atEnd) const;

  /// The vertex of the leaf that lies farthest along a direction, by index.
  [[nodiscard]] int farthestAlong(const Vec3& direction, std::size_t leaf, bool atEnd) const;

  /// How far the leaf's vertices move over the step at most [m].
  [[nodiscard]] double moveOf(std::size_t leaf) const { return moves_.empty() ? 0.0 : moves_[leaf]; }

  MeshShape shape;  ///< with its triangles facing outwards, where it is closed
  bool closed;      ///< it has an inside: every side of a triangle is met by one that runs the other way
  MeshTree tree;
  std::vector<OwnedFeatures> owned;
  std::vector<std::array<bool, 3>> sharp;  ///< for each triangle which of its sides stick out

 private:
  void gatherPatches();
  void fillBoxes(std::span<const Vec3> positions, std::vector<TriangleBoxes>& boxes) const;
  [[nodiscard]] const PatchLanes& lanes(bool atEnd) const { return atEnd && movesInItself() ? end_ : start_; }

  std::vector<int> patchVertices_;       // of the leaves, each a multiple of the lanes; the last of a leaf is repeated
  std::vector<std::size_t> patchBegin_;  // in these
  std::vector<std::array<std::uint8_t, 3>> patchCorners_;  // of each leaf's triangles, counted from where it begins
  std::vector<std::size_t> patchTriangles_;                // where a leaf begins in these
  PatchLanes start_, end_;
  std::vector<TriangleBoxes> startBoxes_, endBoxes_;
  std::vector<double> moves_;
};

/// A unit vector to the front of a triangle; upwards when it has no area.
[[nodiscard]] Vec3 faceNormal(const std::array<Vec3, 3>& corners);

}  // namespace drape
