#pragma once

#include "sim/cloth_model.hpp"
#include "sim/contact/self/float_lanes.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace drape {

/// A part of the cloth that cannot collide with itself (after Volino and Magnenat-Thalmann 1994, Provot 1997): there is
/// a direction that all its triangles face, and the border, seen along that direction, does not cross itself. Seen
/// along the direction no triangle is then turned over, so every point of the plane is covered as often as the border
/// winds around it: at most once. The part may bend as it likes within that, and has no two points above each other.
struct CollisionFreePatch {
  std::array<float, 3> axis = {0.0F, 0.0F, 1.0F};  ///< the direction, of length 1
  int firstCorner = 0;                             ///< its triangles in CollisionFreePatches::corners
  int lastCorner = 0;                              ///< one past the last; both multiples of mostLanes
  int firstBorder = 0;  ///< the border's vertices in CollisionFreePatches::border, in a circle
  int lastBorder = 0;
  int firstVertex =
      0;  ///< its vertices in CollisionFreePatches::vertices; some of the border may belong to another patch
  int lastVertex = 0;
};

/// A cloth divided into collision-free sub-surfaces. Every triangle with an area belongs to one of them, every vertex
/// to the first that one of its triangles belongs to; a vertex that no such triangle has is a sub-surface by itself.
struct CollisionFreePatches {
  std::vector<CollisionFreePatch> patches;
  std::vector<int> patchOfVertex;
  std::vector<int> patchOfTriangle;  ///< -1 where it has no area
  CornerLanes corners;               ///< of the triangles, patch by patch, the last repeated to fill a vector
  std::vector<int> border;           ///< vertex indices
  std::vector<int> vertices;         ///< vertex indices, patch by patch, ascending in each

  [[nodiscard]] int count() const { return static_cast<int>(patches.size()); }
};

/// What a partition needs to know of a mesh.
struct PatchMesh {
  std::vector<Triangle> triangles;
  std::vector<std::array<int, 3>> across;  ///< see trianglesAcross
  CornerLanes corners;                     ///< of all triangles, filled up to a whole vector
  int vertices = 0;
};

[[nodiscard]] PatchMesh patchMeshOf(const ClothModel& model);

/// Tells whether a patch's border, seen along its axis, crosses itself.
class BorderCheck {
 public:
  bool simple(const int* border, int count, const PositionLanes& positions, const std::array<float, 3>& axis);

 private:
  std::vector<float> x_, y_;
};

/// Divides a cloth into collision-free sub-surfaces.
///
/// From the first triangle that is left, a patch grows over the edges, breadth first, by triangles whose normals lie
/// within `growthAngle` of the patch's axis: the mean normal around the first triangle. A triangle is taken only where
/// it leaves the patch a disc: it borders the patch with one edge and its third corner is new to it, or with two.
/// (Every disc of triangles can be grown so.) Then the border is looked at along the axis. Where it crosses itself, the
/// patch is cut back to as many of its triangles, in the order in which they were taken, as have a border that does
/// not: this is a bisection, since what has once grown over itself stays so.
///
/// The time is linear in the number of triangles, but for a factor that is the logarithm of a patch's size where
/// borders cross. The result depends on nothing but the mesh and the places.
class PatchGrower {
 public:
  static constexpr double growthAngle = 60.0;  ///< [degrees]

  /// @param places one a vertex [m]
  void grow(const PatchMesh& mesh, const PositionLanes& positions, CollisionFreePatches& patches);

  /// Grows new patches where old ones were that hold no longer, and keeps the others.
  /// @param holds one for each of the old patches
  void repair(const PatchMesh& mesh, const PositionLanes& positions, const CollisionFreePatches& old,
              const std::vector<char>& valid, CollisionFreePatches& patches);

 private:
  void begin(const PatchMesh& mesh, const PositionLanes& positions, CollisionFreePatches& patches);
  void keepPatches(const CollisionFreePatches& old, const std::vector<char>& valid, CollisionFreePatches& patches);
  void growRest(const PatchMesh& mesh, const PositionLanes& positions, CollisionFreePatches& patches);
  [[nodiscard]] std::array<float, 3> axisAround(const PatchMesh& mesh, int seed);
  void takeFrom(const PatchMesh& mesh, int seed, const std::array<float, 3>& axis, std::size_t maximum);
  [[nodiscard]] bool keepsDisc(const PatchMesh& mesh, int triangle) const;
  void take(const PatchMesh& mesh, int triangle);
  [[nodiscard]] bool faces(int triangle, const std::array<float, 3>& axis) const;
  [[nodiscard]] std::array<float, 3> normal(int triangle) const;
  void giveBack(std::size_t kept);
  void findBorder(const PatchMesh& mesh, std::size_t count);
  void cutBack(const PatchMesh& mesh, const PositionLanes& positions, const std::array<float, 3>& axis);
  void add(const PatchMesh& mesh, const std::array<float, 3>& axis, CollisionFreePatches& patches);
  static void sortVertices(CollisionFreePatches& patches);

  PositionLanes normals_;        // of the triangles, twice their areas long [m^2]
  std::vector<int> owner_;       // by triangle: the attempt that took it, or one of the marks in the source file
  std::vector<int> orderIndex_;  // by triangle: where it stands in the order of its patch
  std::vector<int> attemptOfVertex_;     // by vertex: the last attempt that took a triangle of it
  std::vector<int> order_;       // triangles of the present patch, as they were taken
  std::vector<int> queue_;
  std::vector<int> next_;  // by vertex: the one that follows on the border
  std::vector<int> border_;
  BorderCheck check_;
  int attempt_ = 0;
};

/// Tells whether patches are collision-free still.
class PatchCheck {
 public:
  static constexpr double holdAngle = 85.0;  ///< [degrees]

  /// Which patches have normals within `holdAngle` of their axes and a border that does not cross itself.
  /// @param holds 1 or 0 for each patch  @returns how many do not
  int failures(const CollisionFreePatches& patches, const PositionLanes& positions, std::vector<char>& valid);

 private:
  BorderCheck border_;
};

}  // namespace drape
