#pragma once

#include "sim/contact/closest_features/hull_gap.hpp"
#include "sim/contact/closest_features/mesh_in_step.hpp"

#include <span>
#include <vector>

namespace drape {

/// Looks for vertices and sharp edges of a mesh that are close to one triangle of the cloth: they touch its face and
/// its edges. On what is smooth, as seen from the cloth, there are none, and its vertices suffice: then a plane is
/// found.
class SharpSearch {
 public:
  /// @param close how near something must be to touch [m]  @param near how far away what is near may be, farther [m]
  SharpSearch(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth,
              std::span<const NearVertex> nearest, double close, double near, Findings& findings)
      : side_(side), mesh_(mesh), cloth_(cloth), nearest_(nearest), close_(close), near_(near), findings_(findings) {}

  /// @param patches leaves of the mesh's tree, among them all that come near to triangle t  @param boxes theirs
  /// @param way of its corners, at most [m]
  /// @param outwards the direction of the widest gap that was found last, where to begin, or zero; changed to the new
  /// one
  /// @return how far it is from the mesh at least, at the base [m]; what is farther than near counts as near
  double look(int t, const std::vector<int>& patches, const BoxList& boxes, double way, Vec3& outwards);

 private:
  bool place(int t, const std::vector<int>& patches, const BoxList& boxes);
  [[nodiscard]] Vec3 ownOutwards() const;
  [[nodiscard]] FaceRegion region() const;
  void lookAround(const std::vector<int>& patches, const BoxList& boxes);
  void touchPoint(int bodyTriangle, std::size_t corner);
  void touchEdge(int bodyTriangle, std::size_t side);
  void touch(int bodyTriangle, const Corners& at, const Vec3& weights, const Vec3& bodyWeights);

  const BodySide& side_;
  const MeshInStep& mesh_;
  const ClothInBody& cloth_;
  std::span<const NearVertex> nearest_;
  double close_;
  double near_;
  Findings& findings_;

  std::size_t t_ = 0;
  Corners base_;
  Vec3 normal_ = Vec3::UnitY();
  std::vector<std::int32_t> patches_;  // that are near
  std::vector<InRegion> found_;        // of these
};

}  // namespace drape
