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
struct CollisionFreeChart {
  std::array<float, 3> axis = {0.0F, 0.0F, 1.0F};  ///< the direction, of length 1
  int firstCorner = 0;                             ///< its triangles in SelfCharts::corners
  int lastCorner = 0;                              ///< one past the last; both multiples of mostLanes
  int firstBorder = 0;                             ///< the border's vertices in SelfCharts::border, in a circle
  int lastBorder = 0;
  int firstVertex = 0;  ///< its vertices in SelfCharts::vertices; some of the border may belong to another chart
  int lastVertex = 0;
};

/// A cloth divided into collision-free sub-surfaces. Every triangle with an area belongs to one of them, every vertex
/// to the first that one of its triangles belongs to; a vertex that no such triangle has is a sub-surface by itself.
struct SelfCharts {
  std::vector<CollisionFreeChart> charts;
  std::vector<int> chartOfVertex;
  std::vector<int> chartOfTriangle;  ///< -1 where it has no area
  CornerLanes corners;               ///< of the triangles, chart by chart, the last repeated to fill a vector
  std::vector<int> border;           ///< vertex indices
  std::vector<int> vertices;         ///< vertex indices, chart by chart, ascending in each

  [[nodiscard]] int count() const { return static_cast<int>(charts.size()); }
};

/// What a partition needs to know of a mesh.
struct ChartMesh {
  std::vector<Triangle> triangles;
  std::vector<std::array<int, 3>> across;  ///< see trianglesAcross
  CornerLanes corners;                     ///< of all triangles, filled up to a whole vector
  int vertices = 0;
};

[[nodiscard]] ChartMesh chartMeshOf(const ClothModel& model);

/// Tells whether a chart's border, seen along its axis, crosses itself.
class BorderCheck {
 public:
  bool simple(const int* border, int count, const PlaceLanes& places, const std::array<float, 3>& axis);

 private:
  std::vector<float> x_, y_;
};

/// Divides a cloth into collision-free sub-surfaces.
///
/// From the first triangle that is left, a chart grows over the edges, breadth first, by triangles whose normals lie
/// within `growthAngle` of the chart's axis: the mean normal around the first triangle. A triangle is taken only where
/// it leaves the chart a disc: it borders the chart with one edge and its third corner is new to it, or with two.
/// (Every disc of triangles can be grown so.) Then the border is looked at along the axis. Where it crosses itself, the
/// chart is cut back to as many of its triangles, in the order in which they were taken, as have a border that does
/// not: this is a bisection, since what has once grown over itself stays so.
///
/// The time is linear in the number of triangles, but for a factor that is the logarithm of a chart's size where
/// borders cross. The result depends on nothing but the mesh and the places.
class ChartGrower {
 public:
  static constexpr double growthAngle = 60.0;  ///< [degrees]

  /// @param places one a vertex [m]
  void grow(const ChartMesh& mesh, const PlaceLanes& places, SelfCharts& charts);

  /// Grows new charts where old ones were that hold no longer, and keeps the others.
  /// @param holds one for each of the old charts
  void mend(const ChartMesh& mesh, const PlaceLanes& places, const SelfCharts& old, const std::vector<char>& holds,
            SelfCharts& charts);

 private:
  void begin(const ChartMesh& mesh, const PlaceLanes& places, SelfCharts& charts);
  void keep(const SelfCharts& old, const std::vector<char>& holds, SelfCharts& charts);
  void growRest(const ChartMesh& mesh, const PlaceLanes& places, SelfCharts& charts);
  [[nodiscard]] std::array<float, 3> axisAround(const ChartMesh& mesh, int seed);
  void takeFrom(const ChartMesh& mesh, int seed, const std::array<float, 3>& axis, std::size_t most);
  [[nodiscard]] bool leavesDisc(const ChartMesh& mesh, int triangle) const;
  void take(const ChartMesh& mesh, int triangle);
  [[nodiscard]] bool faces(int triangle, const std::array<float, 3>& axis) const;
  [[nodiscard]] std::array<float, 3> normal(int triangle) const;
  void giveBack(std::size_t kept);
  void findBorder(const ChartMesh& mesh, std::size_t count);
  void cutBack(const ChartMesh& mesh, const PlaceLanes& places, const std::array<float, 3>& axis);
  void add(const ChartMesh& mesh, const std::array<float, 3>& axis, SelfCharts& charts);
  static void sortVertices(SelfCharts& charts);

  PlaceLanes normals_;        // of the triangles, twice their areas long [m^2]
  std::vector<int> owner_;    // by triangle: the attempt that took it, or one of the marks in the source file
  std::vector<int> place_;    // by triangle: where it stands in the order of its chart
  std::vector<int> touched_;  // by vertex: the last attempt that took a triangle of it
  std::vector<int> order_;    // triangles of the present chart, as they were taken
  std::vector<int> queue_;
  std::vector<int> next_;  // by vertex: the one that follows on the border
  std::vector<int> border_;
  BorderCheck check_;
  int attempt_ = 0;
};

/// Tells whether charts are collision-free still.
class ChartCheck {
 public:
  static constexpr double holdAngle = 85.0;  ///< [degrees]

  /// Which charts have normals within `holdAngle` of their axes and a border that does not cross itself.
  /// @param holds 1 or 0 for each chart  @returns how many do not
  int failures(const SelfCharts& charts, const PlaceLanes& places, std::vector<char>& holds);

 private:
  BorderCheck border_;
};

}  // namespace drape
