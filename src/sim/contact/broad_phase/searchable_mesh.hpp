#pragma once

#include "sim/contact/bodies/body.hpp"
#include "sim/contact/broad_phase/mesh_lanes.hpp"
#include "sim/contact/broad_phase/mesh_tree.hpp"
#include "sim/contact/closest_features/cloth_features.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace drape {

/// A corner or a side of a mesh's triangle.
struct MeshFeature {
  int triangle = -1;
  std::size_t at = 0;      ///< which corner, or which side
  int triangleInLeaf = 0;  ///< which triangle of the leaf
};

/// What lies farthest along a direction [m].
struct SupportPoint {
  double height = 0.0;
  Vec3 point = Vec3::Zero();
};

/// A mesh with what is worked out of it for the search: once, and for one that moves in itself at every step.
class SearchableMesh {
 public:
  explicit SearchableMesh(MeshShape mesh);

  /// Follows a mesh that moves in itself: its vertices when the step begins and when it ends [m].
  void follow(std::span<const Vec3> before, std::span<const Vec3> after);

  [[nodiscard]] bool isDeforming() const { return shape.frames.size() > 1; }

  /// The extents of some leaves of the tree along a unit vector; as they are when the step ends, or when it begins.
  /// @return that of all together
  Extent extentsAlong(const Vec3& direction, const std::vector<std::int32_t>& leaves, bool atEnd,
                      std::vector<Extent>& extents) const {
    return drape::extentsAlong(lanes(atEnd), vertexBegin_, leaves, direction, extents);
  }

  /// What of some leaves of the tree lies farthest along a unit vector.
  [[nodiscard]] SupportPoint supportPoint(const Vec3& direction, const std::vector<std::int32_t>& leaves,
                                          bool atEnd) const {
    const LeafLanes& at = lanes(atEnd);
    const SupportIndex far = drape::supportAlong(at, vertexBegin_, leaves, direction);
    return {far.height, Vec3(at.x[far.at], at.y[far.at], at.z[far.at])};
  }

  /// The boxes around the triangles of each leaf, triangle i of the leaf in lane i.
  [[nodiscard]] const std::vector<TriangleBoxes>& triangleBoxes(bool atEnd) const {
    return atEnd && isDeforming() ? endBoxes_ : startBoxes_;
  }

  /// What of some leaves may contact a triangle of the cloth.
  void featuresIn(const FaceRegion& region, const std::vector<std::int32_t>& leaves, bool atEnd,
                  std::vector<InRegion>& found) const {
    const bool end = atEnd && isDeforming();
    inRegion(lanes(atEnd), vertexBegin_, end ? endEdges_ : startEdges_, edgeBegin_, leaves, region, found);
  }

  /// Calls visit(feature, is an edge) for the points and edges that were found in a leaf, as far as they are its own:
  /// triangle after triangle, points before edges.
  template <typename Visit>
  void forEachFeature(std::size_t leaf, InRegion found, Visit&& visit) const {
    const MeshFeature* points = vertexFeatures_.data() + vertexBegin_[leaf];
    const MeshFeature* edges = edgeFeatures_.data() + edgeBegin_[leaf];
    found.points &= (1U << ownPoints_[leaf]) - 1U;
    while ((found.points | found.edges) != 0) {
      const int point = std::countr_zero(found.points);
      const int edge = std::countr_zero(found.edges);
      if (found.edges == 0 || (found.points != 0 && points[point].triangleInLeaf <= edges[edge].triangleInLeaf)) {
        visit(points[point], false);
        found.points &= found.points - 1;
      } else {
        visit(edges[edge], true);
        found.edges &= found.edges - 1;
      }
    }
  }

  /// The vertex of the leaf that lies farthest along a direction, by index.
  [[nodiscard]] int supportVertex(const Vec3& direction, std::size_t leaf, bool atEnd) const;

  /// How far the leaf's vertices move over the step at most [m].
  [[nodiscard]] double moveOf(std::size_t leaf) const { return moves_.empty() ? 0.0 : moves_[leaf]; }

  MeshShape shape;  ///< with its triangles facing outwards, where it is closed
  bool closed;      ///< it has an inside: every side of a triangle is met by one that runs the other way
  MeshTree tree;
  std::vector<OwnedFeatures> owned;
  std::vector<std::array<bool, 3>> sharp;  ///< for each triangle which of its sides stick out

 private:
  void gatherLeaves();
  void gatherPoints(std::span<const int> triangles);
  void gatherEdges(std::span<const int> triangles);
  void fillEdges(std::span<const Vec3> positions, EdgeLanes& edges) const;
  void fillBoxes(std::span<const Vec3> positions, std::vector<TriangleBoxes>& boxes) const;
  [[nodiscard]] const LeafLanes& lanes(bool atEnd) const { return atEnd && isDeforming() ? end_ : start_; }

  std::vector<int> leafVertices_;         // of the leaves, each a multiple of the lanes; the last of a leaf is repeated
  std::vector<std::size_t> vertexBegin_;  // in these
  std::vector<MeshFeature> vertexFeatures_;  // for these as many, of the leaf's own, which come first in it
  std::vector<std::uint32_t> ownPoints_;     // how many of each leaf
  LeafLanes start_, end_;
  std::vector<std::array<int, 2>> leafEdges_;  // of the leaves, each a multiple of the lanes; what is missing is -1
  std::vector<std::size_t> edgeBegin_;         // in these
  std::vector<MeshFeature> edgeFeatures_;      // as many
  EdgeLanes startEdges_, endEdges_;
  std::vector<TriangleBoxes> startBoxes_, endBoxes_;
  std::vector<double> moves_;
};

}  // namespace drape
