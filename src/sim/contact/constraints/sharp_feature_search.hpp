#pragma once

#include "sim/contact/closest_features/hull_gap.hpp"
#include "sim/contact/closest_features/mesh_in_step.hpp"
#include "sim/contact/constraints/constraint_builder.hpp"

#include <span>
#include <vector>

namespace drape {

/// Looks for vertices and sharp edges of a mesh that are close to one triangle of the cloth: they contact its face and
/// its edges. On what is smooth, as seen from the cloth, there are none, and its vertices suffice: then a plane is
/// found.
class SharpFeatureSearch {
 public:
  /// @param close how near something must be to contact [m]  @param near how far away what is near may be, farther [m]
  SharpFeatureSearch(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                     std::span<const NearestMeshPoint> nearest, double close, double near, Candidates& candidates)
      : builder_(builder),
        mesh_(mesh),
        cloth_(cloth),
        nearest_(nearest),
        close_(close),
        near_(near),
        candidates_(candidates) {}

  /// @param leaves leaves of the mesh's tree, among them all that come near to triangle t  @param boxes theirs
  /// @param way of its corners, at most [m]
  /// @param outwards the direction of the widest gap that was found last, where to begin, or zero; changed to the new
  /// one
  /// @return how far it is from the mesh at least, at the base [m]; what is farther than near counts as near
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
  std::vector<std::int32_t> leaves_;  // that are near
  std::vector<InRegion> found_;       // of these
};

}  // namespace drape
