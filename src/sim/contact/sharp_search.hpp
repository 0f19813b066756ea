#pragma once

#include "sim/contact/mesh_in_step.hpp"

#include <span>
#include <vector>

namespace drape {

/// Looks for vertices and sharp edges of a mesh that are close to one triangle of the cloth: they touch its face and
/// its edges. On what is smooth, as seen from the cloth, there are none, and its vertices suffice: then a plane is
/// found.
class SharpSearch {
 public:
  /// @param close how near something must be to touch [m]  @param near the same of what the plane is to cover, farther
  SharpSearch(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth, double close, double near,
              Findings& findings)
      : side_(side), mesh_(mesh), cloth_(cloth), close_(close), near_(near), findings_(findings) {}

  /// @param patches leaves of the mesh's tree, among them all that come near to triangle t  @param boxes theirs
  OwnPlane look(int t, const std::vector<int>& patches, const BoxList& boxes);

  /// The plane alone.
  OwnPlane planeOf(int t, const std::vector<int>& patches, const BoxList& boxes);

  /// A bound below the distance between the triangle that was looked at last and the mesh, at the base: the widest gap
  /// along the plane's normal and those of the nearest points of its corners [m]; what is farther than near counts as
  /// near.
  double distanceAtLeast(const OwnPlane& plane, std::span<const NearVertex> nearest);

 private:
  bool place(int t, const std::vector<int>& patches, const BoxList& boxes);
  [[nodiscard]] OwnPlane plane() const;
  void lookInto(std::size_t patch);
  void touchVertices(int bodyTriangle, const Corners& at);
  void touchEdges(int bodyTriangle, const Corners& at);
  void touch(int bodyTriangle, const Corners& at, const Vec3& weights, const Vec3& bodyWeights);

  const BodySide& side_;
  const MeshInStep& mesh_;
  const ClothInBody& cloth_;
  double close_;
  double near_;
  Findings& findings_;

  std::size_t t_ = 0;
  Corners base_;
  Eigen::AlignedBox3d around_;
  Vec3 normal_ = Vec3::UnitY();
  Extent own_;                         // of the triangle along its normal [m]
  Extent all_;                         // of all that is near [m]
  double low_ = 0.0;                   // along the normal, with what counts as close [m]
  double high_ = 0.0;                  // [m]
  std::vector<std::int32_t> patches_;  // that are near
  std::vector<Extent> extents_;        // of these along the normal
};

}  // namespace drape
