#pragma once

#include "sim/vector.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace drape {

/// Numbers in the widest vector that is used here, and so the room that arrays have beyond their end.
inline constexpr std::size_t maxDoubles = 8;

/// How far something reaches along a direction [m]; empty (low above high) until something is put in.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

/// Axis-aligned boxes, one array a coordinate [m].
class BoxList {
 public:
  void clear() { size_ = 0; }
  void add(const Eigen::AlignedBox3d& box);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const double* low(std::size_t axis) const { return low_[axis].data(); }
  [[nodiscard]] const double* high(std::size_t axis) const { return high_[axis].data(); }

 private:
  std::size_t size_ = 0;
  std::array<std::vector<double>, 3> low_, high_;  // longer by a vector, which holds anything
};

inline constexpr std::size_t trianglesPerLeaf = 4;  ///< that are looked at together

/// The boxes around the triangles of a leaf; what is missing lies at infinity [m].
struct TriangleBoxes {
  std::array<std::array<double, trianglesPerLeaf>, 3> low, high;
};

/// The vertices of the leaves of a mesh, leaf after leaf, one array a coordinate [m]. Each leaf fills whole
/// vectors: its last vertex is repeated.
struct LeafLanes {
  std::vector<double> x, y, z;
};

/// The edges of the leaves of a mesh that stick out, leaf after leaf, from one end to the other. Each leaf fills
/// whole vectors: what is missing lies at infinity.
struct EdgeLanes {
  LeafLanes from, to;
};

/// What may contact a triangle of the cloth: near its box, and between two heights over it; of points only what lies
/// above or below it, of edges the rest as well.
struct FaceRegion {
  Eigen::AlignedBox3d box;      ///< [m]
  Vec3 normal = Vec3::UnitY();  ///< of the triangle
  double low = 0.0;             ///< along the normal [m] ...
  double high = 0.0;            ///< ... and the other end [m]
  Vec3 corner = Vec3::Zero();   ///< the triangle's first [m]
  /// The weights of the second and third corner at a point are these, times its way from the first [1/m].
  std::array<Vec3, 2> weights{Vec3::Zero(), Vec3::Zero()};
};

/// Which of a leaf's points and edges lie in a region, the first of them in bit 0.
struct InRegion {
  std::uint32_t points = 0;
  std::uint32_t edges = 0;
};

// What follows runs by the widest vector instructions that the machine has, and gives the same bits with any.

/// The indices of the boxes that meet `box`, ascending.
void boxesMeeting(const BoxList& boxes, const Eigen::AlignedBox3d& box, std::vector<std::int32_t>& met);

/// The squared distances from a point to boxes, 0 inside [m^2].
void squaredDistances(const BoxList& boxes, const Vec3& point, std::vector<double>& squared);

/// The squared distances from a point to the boxes of all triangles of some leaves, 0 inside [m^2]: those of leaf k
/// from trianglesOfPatch * k on.
/// @param boxes of all leaves
void squaredDistances(const std::vector<TriangleBoxes>& boxes, const std::vector<std::int32_t>& leaves,
                      const Vec3& point, std::vector<double>& squared);

/// What of some leaves lies farthest along a direction.
struct SupportIndex {
  double height = -std::numeric_limits<double>::infinity();  ///< along the direction [m]
  std::size_t at = 0;                                        ///< among the lanes; of several the first
};
SupportIndex supportAlong(const LeafLanes& lanes, const std::vector<std::size_t>& begin,
                          const std::vector<std::int32_t>& leaves, const Vec3& direction);

/// Writes for each of some leaves what of it lies in a region.
/// @param begin of each leaf among the points, and of what would come after the last one  @param edgeBegin the same
void inRegion(const LeafLanes& points, const std::vector<std::size_t>& begin, const EdgeLanes& edges,
              const std::vector<std::size_t>& edgeBegin, const std::vector<std::int32_t>& leaves,
              const FaceRegion& region, std::vector<InRegion>& found);

/// Writes the extents of some leaves along a direction, and returns that of all together.
/// @param begin of each leaf in `lanes`, and of what would come after the last one
Extent extentsAlong(const LeafLanes& lanes, const std::vector<std::size_t>& begin,
                    const std::vector<std::int32_t>& leaves, const Vec3& direction, std::vector<Extent>& extents);

}  // namespace drape
