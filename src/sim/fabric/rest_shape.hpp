#pragma once

#include "sim/model/mesh_topology.hpp"
#include "sim/model/vector.hpp"

#include <array>
#include <span>
#include <vector>

namespace drape::sim::fabric {

/// A triangle of the rest shape in its own plane, with coordinates along warp and weft. Side k goes from corner k to
/// the next one.
struct RestTriangle {
  std::array<Vec2, 3> sides = {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};  ///< [m]
  double area = 0.0;    ///< [m^2]; 0 for a degenerate triangle, which has no stiffness
  bool isBand = false;  ///< part of an elastic band, which is stretched while it is worn
};

/// The shape of a triangle [-]: 4 sqrt(3) A over the sum of its squared sides, 1 for an equilateral triangle, 0 for a
/// degenerate one. The highest frequency of a triangle goes up with its inverse.
[[nodiscard]] double qualityOf(const RestTriangle& triangle);

/// A triangle of lower quality (qualityOf) is a sliver. Its moduli are scaled by its quality over this value. Otherwise
/// a few slivers would determine the time step of the whole cloth.
inline constexpr double sliverQuality = 0.1;

/// A triangle as seen from one of its sides. The side's direction is given by the caller.
struct SideFrame {
  Vec2 along = Vec2::Zero();    ///< the side's direction, along warp and weft [-]
  Vec2 outward = Vec2::Zero();  ///< its normal out of the triangle, along warp and weft [-]
  double length = 0.0;          ///< of the side [m]
  double height = 0.0;          ///< of the opposite corner over the side [m]
  double offset = 0.0;          ///< of the opposite corner from the middle of the side, along it [m]
};

/// @param side of the triangle, which must not be degenerate  @param reversed whether the direction is against the
/// side's own, which goes from its corner to the next one
[[nodiscard]] SideFrame sideFrameOf(const RestTriangle& triangle, int side, bool reversed);

/// Two triangles that share an edge. The fabric bends about it.
struct Hinge {
  std::array<int, 4> vertices = {};   ///< the ends of the edge, then the corner opposite to it in either triangle
  std::array<int, 2> triangles = {};  ///< in the order of the opposite corners
  std::array<int, 2> sides = {};      ///< of these triangles
  std::array<SideFrame, 2> frames;    ///< of these sides, along the edge from its first end to its second
  Eigen::Vector4d weights = Eigen::Vector4d::Zero();  ///< of the vertices: sum of w_i x_i is the bend vector [1/m]
};

/// The geometry of a fabric's rest shape.
struct RestShape {
  std::vector<RestTriangle> triangles;
  std::vector<Hinge> hinges;  ///< one for each edge of two triangles that are not degenerate
};

/// The direction of warp in each triangle: `direction` projected onto its plane. A triangle that is perpendicular to
/// `direction` takes the coordinate axis that is closest to the triangle's plane, x before y before z.
/// @return one unit vector a triangle; zero for a degenerate triangle
[[nodiscard]] std::vector<Vec3> warpAlong(const Vec3& direction, std::span<const Vec3> positions,
                                          std::span<const Triangle> triangles);

/// The triangles of a mesh, each in its own plane.
/// @param positions at rest [m]  @param warp a direction in the plane of each triangle
[[nodiscard]] std::vector<RestTriangle> restTrianglesOf(std::span<const Vec3> positions,
                                                        std::span<const Triangle> triangles,
                                                        std::span<const Vec3> warp);

/// A triangle of a flat pattern. @param corners in coordinates along warp and weft [m]. Their order may be clockwise,
/// as in a piece that is cut from the back of the cloth: weft then points the other way.
[[nodiscard]] RestTriangle restTriangleOf(const std::array<Vec2, 3>& corners);

/// The rest shape of these triangles, which may come from a mesh or from a pattern. Two triangles of a pattern may give
/// their common edge different lengths, at a seam. Then either side of the hinge has the length of its own triangle.
/// @param rest one for each of the triangles  @param edges of these triangles
[[nodiscard]] RestShape restShapeOf(std::vector<RestTriangle> rest, std::span<const Triangle> triangles,
                                    const MeshEdges& edges);

/// The rest shape of a mesh, see restTrianglesOf. @param edges of these triangles
[[nodiscard]] RestShape restShapeOf(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                                    const MeshEdges& edges, std::span<const Vec3> warp);

}  // namespace drape::sim::fabric
