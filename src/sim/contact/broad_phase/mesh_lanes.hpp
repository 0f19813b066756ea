#pragma once

#include "sim/model/vector.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace drape::sim::contact {

/// Number of doubles in the widest vector in use. Arrays have that much padding at their end.
inline constexpr std::size_t maxDoubles = 8;

/// An interval along a direction [m]; initially empty (low > high).
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

/// Axis-aligned boxes, one array per coordinate [m].
class BoxList {
 public:
  void clear() { size_ = 0; }
  void add(const Eigen::AlignedBox3d& box);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const double* low(std::size_t axis) const { return low_[axis].data(); }
  [[nodiscard]] const double* high(std::size_t axis) const { return high_[axis].data(); }

 private:
  std::size_t size_ = 0;
  std::array<std::vector<double>, 3> low_, high_;  // padded by one vector of arbitrary values
};

/// Maximum number of triangles in a leaf of a body's mesh. They are processed together.
inline constexpr std::size_t trianglesPerLeaf = 4;

/// The bounding boxes of the triangles of a leaf [m]. If the leaf has fewer triangles, the other boxes lie at infinity.
struct TriangleBoxes {
  std::array<std::array<double, trianglesPerLeaf>, 3> low, high;
};

/// The vertices of the leaves of a mesh, leaf after leaf, one array per coordinate [m]. Each leaf is padded to whole
/// vectors by copies of its last vertex.
struct LeafLanes {
  std::vector<double> x, y, z;
};

/// The sharp edges of the leaves of a mesh, leaf after leaf, by their two ends. Each leaf is padded to whole vectors by
/// edges at infinity.
struct EdgeLanes {
  LeafLanes from, to;
};

/// The region in which features of a mesh can be in contact with a triangle of the cloth: a box, and a range along the
/// triangle's normal. Points must also project into the triangle, unless the weights are zero.
struct FaceRegion {
  Eigen::AlignedBox3d box;      ///< [m]
  Vec3 normal = Vec3::UnitY();  ///< unit normal of the triangle
  double low = 0.0;             ///< minimum along the normal [m]
  double high = 0.0;            ///< maximum along the normal [m]
  Vec3 corner = Vec3::Zero();   ///< first corner of the triangle [m]
  /// The barycentric coordinates of the second and third corner at a point are the dot products of these with the
  /// offset from the first corner [1/m].
  std::array<Vec3, 2> weights{Vec3::Zero(), Vec3::Zero()};
};

/// The points and edges of a leaf in a region, as bit masks; bit 0 is the first.
struct InRegion {
  std::uint32_t points = 0;
  std::uint32_t edges = 0;
};

// The functions below use the widest vector instructions of the machine. Their results have the same bits with any
// instruction set.

/// Finds the indices of the boxes that intersect `box`, ascending. @param met result
void boxesMeeting(const BoxList& boxes, const Eigen::AlignedBox3d& box, std::vector<std::int32_t>& met);

/// Computes the squared distances from a point to boxes, 0 inside [m^2]. @param squared result, one for each box
void squaredDistances(const BoxList& boxes, const Vec3& point, std::vector<double>& squared);

/// Computes the squared distances from a point to the boxes of all triangles of some leaves, 0 inside [m^2].
/// @param boxes of all leaves of the mesh  @param leaves indices into `boxes`
/// @param squared result; that of triangle i of leaves[k] has the index trianglesPerLeaf * k + i
void squaredDistances(const std::vector<TriangleBoxes>& boxes, const std::vector<std::int32_t>& leaves,
                      const Vec3& point, std::vector<double>& squared);

/// A vertex with the maximum coordinate along a direction.
struct SupportIndex {
  double height = -std::numeric_limits<double>::infinity();  ///< along the direction [m]
  std::size_t at = 0;                                        ///< index into the lanes; the first of several
};

/// The vertex of some leaves with the maximum coordinate along a direction.
/// @param begin first vertex of each leaf in `lanes`, and one past the last
SupportIndex supportAlong(const LeafLanes& lanes, const std::vector<std::size_t>& begin,
                          const std::vector<std::int32_t>& leaves, const Vec3& direction);

/// Writes for each of some leaves which of its features lie in a region.
/// @param begin first point of each leaf, and one past the last  @param edgeBegin the same for edges
void inRegion(const LeafLanes& points, const std::vector<std::size_t>& begin, const EdgeLanes& edges,
              const std::vector<std::size_t>& edgeBegin, const std::vector<std::int32_t>& leaves,
              const FaceRegion& region, std::vector<InRegion>& found);

/// Writes the extents of some leaves along a direction, and returns their union.
/// @param begin first vertex of each leaf in `lanes`, and one past the last
Extent extentsAlong(const LeafLanes& lanes, const std::vector<std::size_t>& begin,
                    const std::vector<std::int32_t>& leaves, const Vec3& direction, std::vector<Extent>& extents);

}  // namespace drape::sim::contact
