#pragma once

#include "sim/contact/self/float_lanes.hpp"
#include "sim/model/cloth_model.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// A part of the cloth that cannot collide with itself (after Volino and Magnenat-Thalmann 1994, Provot 1997): all its
/// triangles face one direction, the axis, and the projection of the border along the axis does not intersect itself.
/// So no projected triangle is flipped, and each point of the plane is covered as often as the border winds around it:
/// at most once. Hence no two points of the patch lie above each other, whatever its curvature.
struct CollisionFreePatch {
  std::array<float, 3> axis = {0.0F, 0.0F, 1.0F};  ///< unit vector
  int firstCorner = 0;                             ///< its triangles in CollisionFreePatches::corners
  int lastCorner = 0;                              ///< one past the last; both are multiples of maxLanes
  int firstBorder = 0;  ///< its border vertices in CollisionFreePatches::border, in cyclic order
  int lastBorder = 0;
  /// Its vertices in CollisionFreePatches::vertices. Some border vertices may belong to another patch.
  int firstVertex = 0;
  int lastVertex = 0;
};

/// Collision-free patches of a cloth that share no triangle. In a partition every triangle with an area belongs to one
/// patch, every vertex to the first patch of its triangles. A vertex without such triangles is a patch of one vertex.
struct CollisionFreePatches {
  std::vector<CollisionFreePatch> patches;
  std::vector<int> patchOfVertex;
  std::vector<int> patchOfTriangle;  ///< -1: it belongs to none
  CornerLanes corners;               ///< of the triangles, patch by patch, padded by copies of the last one
  std::vector<int> border;           ///< vertex indices
  std::vector<int> vertices;         ///< vertex indices, patch by patch, ascending in each

  [[nodiscard]] int count() const { return static_cast<int>(patches.size()); }
};

/// The common patch of all triangles around each vertex; -1: there is none, -2: the vertex has no triangles.
[[nodiscard]] std::vector<int> patchesAroundVertices(const std::vector<Triangle>& triangles,
                                                     const CollisionFreePatches& patches);

/// The data of a cloth's mesh for a partition.
struct PatchMesh {
  std::vector<Triangle> triangles;
  std::vector<std::array<int, 3>> across;  ///< see trianglesAcross
  CornerLanes corners;                     ///< of all triangles, padded to whole vectors
  int vertices = 0;
};

[[nodiscard]] PatchMesh patchMeshOf(const ClothModel& model);

/// Checks whether the projection of a patch's border along its axis is a simple polygon.
class BorderCheck {
 public:
  /// Sides that come closer to each other than this may count as touching [m].
  float margin = 0.0F;

  /// @param border vertices of the border in cyclic order  @param count their number
  bool simple(const int* border, int count, const PositionLanes& positions, const std::array<float, 3>& axis);

 private:
  std::vector<float> x_, y_;  // projected border [m]
};

/// Partitions a cloth into collision-free patches.
///
/// A patch grows breadth first over the edges from the first remaining triangle. It takes triangles whose normals are
/// within `growthAngle` of its axis, the mean normal around the first triangle. A triangle is taken only if the patch
/// stays a topological disc: it shares one edge with the patch and its third corner is new, or it shares two edges.
/// (Every disc of triangles can be grown this way.) If the projected border intersects itself, the patch is cut back to
/// its first triangles with a simple border. Bisection finds their number, since a patch that overlaps itself keeps
/// overlapping as it grows.
///
/// The time is linear in the number of triangles, times the logarithm of a patch's size where borders intersect. The
/// result depends only on the mesh and the positions.
class PatchGrower {
 public:
  static constexpr double growthAngle = 60.0;  ///< [degrees]

  /// See BorderCheck; initially 0 [m].
  void setBorderMargin(float margin) { check_.margin = margin; }

  /// Partitions the whole cloth. @param positions per vertex [m]  @param patches the result
  void grow(const PatchMesh& mesh, const PositionLanes& positions, CollisionFreePatches& patches);

  /// Grows patches across borders, each from a triangle with a corner that is at a border of all other sets of patches.
  /// So features near a border of these belong to a common patch, except near a border of all sets.
  /// @param patches the result, without vertices
  void growAcrossBorders(const PatchMesh& mesh, const PositionLanes& positions,
                         std::span<const std::shared_ptr<const CollisionFreePatches>> others,
                         CollisionFreePatches& patches);

  /// Replaces patches that are no longer valid by new ones, and keeps the others.
  /// @param valid per old patch: 1 or 0, see PatchCheck  @param patches the result
  void repair(const PatchMesh& mesh, const PositionLanes& positions, const CollisionFreePatches& old,
              const std::vector<char>& valid, CollisionFreePatches& patches);

 private:
  void begin(const PatchMesh& mesh, const PositionLanes& positions, CollisionFreePatches& patches);
  void keepPatches(const CollisionFreePatches& old, const std::vector<char>& valid, CollisionFreePatches& patches);
  void growFrom(const PatchMesh& mesh, const PositionLanes& positions, int seed, float axisSquaredCosine,
                CollisionFreePatches& patches);
  void growRest(const PatchMesh& mesh, const PositionLanes& positions, CollisionFreePatches& patches);
  [[nodiscard]] std::array<float, 3> axisAround(const PatchMesh& mesh, int seed, float minSquaredCosine);
  void takeFrom(const PatchMesh& mesh, int seed, const std::array<float, 3>& axis, float minSquaredCosine,
                std::size_t maximum);
  [[nodiscard]] bool keepsDisc(const PatchMesh& mesh, int triangle) const;
  void take(const PatchMesh& mesh, int triangle);
  [[nodiscard]] bool faces(int triangle, const std::array<float, 3>& axis, float minSquaredCosine) const;
  [[nodiscard]] std::array<float, 3> normal(int triangle) const;
  void giveBack(std::size_t kept);
  void findBorder(const PatchMesh& mesh, std::size_t count);
  void cutBack(const PatchMesh& mesh, const PositionLanes& positions, const std::array<float, 3>& axis);
  void add(const PatchMesh& mesh, const std::array<float, 3>& axis, CollisionFreePatches& patches);
  static void sortVertices(CollisionFreePatches& patches);

  PositionLanes normals_;             // of the triangles; their lengths are twice the areas [m^2]
  std::vector<int> owner_;            // by triangle: the attempt that took it, or a negative constant (source file)
  std::vector<int> orderIndex_;       // by triangle: index in the order of its patch
  std::vector<int> attemptOfVertex_;  // by vertex: the last attempt that took one of its triangles
  std::vector<int> order_;            // triangles of the current patch, in the order in which they were taken
  std::vector<int> queue_;
  std::vector<int> next_;  // by vertex: the next vertex on the border
  std::vector<int> border_;
  BorderCheck check_;
  int attempt_ = 0;
};

/// Checks whether patches are still collision-free.
class PatchCheck {
 public:
  static constexpr double holdAngle = 85.0;  ///< [degrees]

  /// See BorderCheck; initially 0 [m].
  void setBorderMargin(float margin) { border_.margin = margin; }

  /// Checks that normals are within `holdAngle` of the axes and that borders do not intersect themselves.
  /// @param valid 1 or 0 for each patch  @returns number of invalid patches
  int failures(const CollisionFreePatches& patches, const PositionLanes& positions, std::vector<char>& valid);

 private:
  BorderCheck border_;
};

}  // namespace drape::sim::contact
