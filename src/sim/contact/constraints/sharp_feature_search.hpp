#pragma once

#include "sim/contact/closest_features/hull_gap.hpp"
#include "sim/contact/closest_features/mesh_in_step.hpp"
#include "sim/contact/constraints/constraint_builder.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// Finds contacts of one triangle of the cloth with vertices and sharp edges of a mesh: vertices of the mesh with its
/// face, edges of the mesh with its edges. On surfaces that are smooth at the scale of the cloth there are none; then
/// the search ends when it finds a plane with a wide enough gap.
class SharpFeatureSearch {
 public:
  /// @param close distance below which features get contacts [m]  @param near distance up to which to search [m]
  SharpFeatureSearch(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                     std::span<const NearestMeshPoint> nearest, double close, double near, Candidates& candidates)
      : builder_(builder),
        mesh_(mesh),
        cloth_(cloth),
        nearest_(nearest),
        close_(close),
        near_(near),
        candidates_(candidates) {}

  /// @param leaves leaves of the mesh's tree, including all near triangle t  @param boxes of these leaves
  /// @param maxDisplacement of its corners [m]
  /// @param outwards direction in which the search starts: that of the widest gap found last, or zero; updated
  /// @return lower bound of the distance to the mesh at the start of the pass [m], at most `near`
  double search(int t, const std::vector<int>& leaves, const BoxList& boxes, double maxDisplacement, Vec3& outwards);

 private:
  bool findNearbyLeaves(int t, const std::vector<int>& leaves, const BoxList& boxes);
  [[nodiscard]] Vec3 outwardNormal() const;
  [[nodiscard]] FaceRegion region() const;
  void searchFeatures(const std::vector<int>& leaves, const BoxList& boxes);
  void addVertexContact(int bodyTriangle, std::size_t corner);
  void addEdgeContact(int bodyTriangle, std::size_t side);
  void contact(int bodyTriangle, const Corners& at, const Vec3& weights, const Vec3& bodyWeights);

  const ConstraintBuilder& builder_;
  const MeshInStep& mesh_;
  const ClothInBody& cloth_;
  std::span<const NearestMeshPoint> nearest_;
  double close_;
  double near_;
  Candidates& candidates_;

  std::size_t t_ = 0;
  Corners start_;
  Vec3 normal_ = Vec3::UnitY();
  std::vector<std::int32_t> leaves_;  // near the triangle
  std::vector<InRegion> found_;       // features of these leaves
};

}  // namespace drape::sim::contact
