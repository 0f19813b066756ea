#pragma once

#include "sim/contact/closest_features/hull_gap.hpp"
#include "sim/contact/closest_features/mesh_in_step.hpp"
#include "sim/contact/constraints/constraint_builder.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// A triangle of the cloth and one of a mesh that intersect at the start of the pass.
struct Piercing {
  int cloth = 0;
  int body = 0;
};

/// Finds planes that separate one triangle of the cloth from every triangle of a mesh that it could reach within its
/// displacement bounds.
///
/// 1. One plane for all leaves of the mesh within reach usually suffices. On a rigid mesh it lies in the gap between
///    the convex hull of these leaves and that of the triangle at its start and its predicted positions. Such a plane
///    does not restrict the predicted motion. On a deforming mesh it is one of the planes normal to the offsets from
///    the closest points to the corners, or the plane of the triangle.
/// 2. If there is no such plane, the one that separates most leaves is used for the triangles that it separates.
/// 3. The other triangles of the mesh get planes at the closest points, one by one.
class PlaneSearch {
 public:
  /// @param cloth its predicted positions are those before the planes are applied
  /// @param nearest closest point of the mesh to each vertex  @param candidates the planes are appended
  PlaneSearch(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
              std::span<const NearestMeshPoint> nearest, Candidates& candidates)
      : builder_(builder), mesh_(mesh), cloth_(cloth), nearest_(nearest), candidates_(candidates) {}

  /// Adds the planes of triangle t.
  /// @param leaves leaves of the mesh's tree, including all that the triangle could reach  @param boxes of these leaves
  void search(int t, const std::vector<int>& leaves, const BoxList& boxes);

  /// Adds a pair that is known to intersect.
  void addPiercing(const Piercing& piercing) { piercings_.push_back(piercing); }
  /// The pairs that intersect, so that no plane separates them.
  [[nodiscard]] const std::vector<Piercing>& piercings() const { return piercings_; }

 private:
  struct Plane {
    Vec3 normal = Vec3::UnitY();
    double startLow = 0.0;      // minimum over the triangle of the cloth at its start [m]
    double predictedLow = 0.0;  // and at its predicted positions [m]
    double startTop = -std::numeric_limits<double>::infinity();  // maximum of the separated part at the start [m]
    double endTop = -std::numeric_limits<double>::infinity();    // and at the end [m]

    /// Adds a part of the mesh with these maxima [m].
    void cover(double start, double end) {
      startTop = std::max(startTop, start);
      endTop = std::max(endTop, end);
    }
  };
  /// A triangle of the mesh that the first plane does not separate.
  struct Rest {
    int triangle;
    bool done;  // another plane separates it
  };

  void prepare();
  bool separateAtOnce();
  bool offerWidestGap(const Vec3& along);
  bool offerOwnPlane();
  bool offer(const Vec3& normal);
  void coverSome();
  void separateRest();
  void separateOne(std::size_t first);
  [[nodiscard]] Plane planeAlong(const Vec3& normal) const;
  [[nodiscard]] bool covers(const Plane& plane, double startTop, double endTop) const;
  void measure(const Vec3& normal);
  [[nodiscard]] bool outOfReach(const std::vector<Vec3>& normals, int triangle) const;
  void addPlanes(const Plane& plane);

  const ConstraintBuilder& builder_;
  const MeshInStep& mesh_;
  const ClothInBody& cloth_;
  std::span<const NearestMeshPoint> nearest_;
  Candidates& candidates_;

  std::size_t t_ = 0;                 // the triangle of the cloth
  Corners start_, predicted_;         // its corners [m]
  double maxBound_ = 0.0;             // maximum displacement bound of its vertices [m]
  Eigen::AlignedBox3d reachableBox_;  // region that its vertices could reach
  std::vector<std::int32_t> leaves_;  // within reach
  std::vector<Extent> extents_;       // of the leaves along a normal, at the start of the pass
  std::vector<Extent> endExtents_;    // and at the end of the step
  std::vector<Vec3> normals_;         // tried so far
  std::vector<Rest> rest_;
  std::vector<Piercing> piercings_;
};

}  // namespace drape::sim::contact
