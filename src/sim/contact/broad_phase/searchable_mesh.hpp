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

namespace drape::sim::contact {

/// A corner or a side of a triangle of a mesh.
struct MeshFeature {
  int triangle = -1;
  std::size_t at = 0;      ///< index of the corner or side
  int triangleInLeaf = 0;  ///< index of the triangle in its leaf
};

/// A point with the maximum coordinate along a direction [m].
struct SupportPoint {
  double height = 0.0;
  Vec3 point = Vec3::Zero();
};

/// A mesh with its search structures. They are built once, and updated in every step for a deforming mesh. All
/// coordinates are in the body's frame. `atEnd` chooses between the start and the end of the step; for a rigid mesh
/// both are the same.
class SearchableMesh {
 public:
  explicit SearchableMesh(MeshShape mesh);

  /// Updates a deforming mesh to its vertices at the start and at the end of the step [m]. Does nothing if they are
  /// those of the last call.
  void follow(std::span<const Vec3> before, std::span<const Vec3> after);

  /// A number that changes when the vertices of a deforming mesh change.
  [[nodiscard]] std::uint64_t version() const { return version_; }

  [[nodiscard]] bool isDeforming() const { return shape.deforms(); }

  /// Computes the extents of some leaves of the tree along a unit vector.
  /// @param extents result, one for each of `leaves`  @return their union
  Extent extentsAlong(const Vec3& direction, const std::vector<std::int32_t>& leaves, bool atEnd,
                      std::vector<Extent>& extents) const {
    return drape::sim::contact::extentsAlong(geometry(atEnd).points, vertexBegin_, leaves, direction, extents);
  }

  /// The support point of some leaves of the tree along a unit vector.
  [[nodiscard]] SupportPoint supportPoint(const Vec3& direction, const std::vector<std::int32_t>& leaves,
                                          bool atEnd) const {
    const LeafLanes& at = geometry(atEnd).points;
    const SupportIndex far = drape::sim::contact::supportAlong(at, vertexBegin_, leaves, direction);
    return {far.height, Vec3(at.x[far.at], at.y[far.at], at.z[far.at])};
  }

  /// The bounding boxes of the triangles of each leaf; triangle i of the leaf is in lane i.
  [[nodiscard]] const std::vector<TriangleBoxes>& triangleBoxes(bool atEnd) const { return geometry(atEnd).boxes; }

  /// Finds the features of some leaves that lie in a region. @param found result, one for each of `leaves`
  void featuresIn(const FaceRegion& region, const std::vector<std::int32_t>& leaves, bool atEnd,
                  std::vector<InRegion>& found) const {
    const Geometry& at = geometry(atEnd);
    inRegion(at.points, vertexBegin_, at.edges, edgeBegin_, leaves, region, found);
  }

  /// Calls visit(feature, is an edge) for those points and edges of `found` that the leaf owns: triangle by triangle,
  /// points before edges. @param found an entry of featuresIn
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

  /// The index of the vertex of the leaf with the maximum coordinate along a direction.
  [[nodiscard]] int supportVertex(const Vec3& direction, std::size_t leaf, bool atEnd) const;

  /// Maximum displacement of the leaf's vertices over the step [m].
  [[nodiscard]] double moveOf(std::size_t leaf) const { return moves_.empty() ? 0.0 : moves_[leaf]; }

  MeshShape shape;  ///< with triangles that face outwards if the mesh is closed
  bool closed;  ///< every side of a triangle is paired with one in the opposite direction, so the mesh has an inside
  MeshTree tree;
  std::vector<OwnedFeatures> owned;        ///< one per triangle
  std::vector<std::array<bool, 3>> sharp;  ///< per triangle: which of its sides are sharp

 private:
  /// What a search reads, at the start or at the end of the step, by leaf.
  struct Geometry {
    LeafLanes points;
    EdgeLanes edges;
    std::vector<TriangleBoxes> boxes;
  };

  void gatherLeaves();
  void gatherPoints(std::span<const int> triangles);
  void gatherEdges(std::span<const int> triangles);
  void fill(std::span<const Vec3> positions, Geometry& geometry) const;
  void fillEdges(std::span<const Vec3> positions, EdgeLanes& edges) const;
  void fillBoxes(std::span<const Vec3> positions, std::vector<TriangleBoxes>& boxes) const;
  void measureMoves();
  [[nodiscard]] const Geometry& geometry(bool atEnd) const { return atEnd && isDeforming() ? end_ : start_; }

  std::vector<int> leafVertices_;         // by leaf, padded by the last one to whole vectors
  std::vector<std::size_t> vertexBegin_;  // of each leaf in leafVertices_
  std::vector<MeshFeature>
      vertexFeatures_;                    // of the same size; valid for vertices that the leaf owns, which come first
  std::vector<std::uint32_t> ownPoints_;  // number of vertices that each leaf owns
  std::vector<std::array<int, 2>> leafEdges_;  // by leaf, padded by -1 to whole vectors
  std::vector<std::size_t> edgeBegin_;         // of each leaf in leafEdges_
  std::vector<MeshFeature> edgeFeatures_;      // of the same size as leafEdges_
  std::vector<Vec3> before_, after_;           // of the last call of follow [m]
  Geometry start_, end_;                       // end_ only for a deforming mesh
  std::vector<double> moves_;                  // by leaf [m]
  std::uint64_t version_ = 0;
};

}  // namespace drape::sim::contact
