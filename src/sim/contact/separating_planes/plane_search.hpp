#pragma once

#include "sim/contact/closest_features/hull_gap.hpp"
#include "sim/contact/closest_features/mesh_in_step.hpp"
#include "sim/contact/constraints/constraint_builder.hpp"

#include <span>
#include <vector>

namespace drape {

/// A triangle of the cloth and one of a mesh that intersect where the cloth should be safe.
struct Piercing {
  int cloth = 0;
  int body = 0;
};

/// Puts planes between one triangle of the cloth and what of a mesh it could meet within its room.
///
/// Mostly one plane does for all: one in the gap between the hulls of what it could meet and of the triangle, at its
/// base and where it is about to go. It stands in nobody's way. Of a mesh that moves in itself the triangle's own plane
/// and those across the way from its corners to the mesh are tried.
/// What is not on the other side of such a plane gets planes through the nearest points, triangle by triangle.
class PlaneSearch {
 public:
  /// @param cloth its target is where it goes if no plane stops it
  PlaneSearch(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
              std::span<const NearestMeshPoint> nearest, Candidates& candidates)
      : builder_(builder), mesh_(mesh), cloth_(cloth), nearest_(nearest), candidates_(candidates) {}

  /// @param leaves leaves of the mesh's tree, among them all that triangle t could reach  @param boxes theirs
  void search(int t, const std::vector<int>& leaves, const BoxList& boxes);

  /// The pairs without a plane between them.
  /// Takes in what is known to pierce, as if it had been found now.
  void addPiercing(const Piercing& piercing) { piercings_.push_back(piercing); }
  [[nodiscard]] const std::vector<Piercing>& piercings() const { return piercings_; }

 private:
  struct Plane {
    Vec3 normal = Vec3::UnitY();
    double startLow = 0.0;                                       // of the cloth's triangle at its base ...
    double predictedLow = 0.0;                                   // ... and where it goes [m]
    double startTop = -std::numeric_limits<double>::infinity();  // of what is covered, at the base ...
    double endTop = -std::numeric_limits<double>::infinity();    // ... and at the end of the step [m]

    void cover(double start, double end) {
      startTop = std::max(startTop, start);
      endTop = std::max(endTop, end);
    }
  };
  struct Rest {
    int triangle;
    bool done;
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
  void raise(const Plane& plane);

  const ConstraintBuilder& builder_;
  const MeshInStep& mesh_;
  const ClothInBody& cloth_;
  std::span<const NearestMeshPoint> nearest_;
  Candidates& candidates_;

  std::size_t t_ = 0;
  Corners start_, predicted_;
  double maxBound_ = 0.0;             // the most of its vertices [m]
  Eigen::AlignedBox3d reachableBox_;  // where its vertices could come
  std::vector<std::int32_t> leaves_;
  std::vector<Extent> extents_;     // of the leaves along a normal, at the base ...
  std::vector<Extent> endExtents_;  // ... and at the end of the step
  std::vector<Vec3> normals_;       // tried so far
  std::vector<Rest> rest_;
  std::vector<Piercing> piercings_;
};

}  // namespace drape
