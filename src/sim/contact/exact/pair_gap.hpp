#pragma once

#include "sim/contact/exact/feature_mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace drape::sim::contact {

/// Two features of a cloth without common vertices: a vertex and a triangle, or two edges. While no such pair meets, no
/// two triangles of the cloth begin to intersect: the first contact of two triangles is one of a vertex with a triangle
/// or of two edges.
struct FeaturePair {
  std::int32_t first = 0;   ///< a vertex, or an edge
  std::int32_t second = 0;  ///< a triangle, or an edge
  bool edges = false;       ///< whether both are edges
};

/// The vertices of a pair: first those of the first feature, then those of the second.
struct PairVertices {
  std::array<int, 4> all{};
  std::size_t firstCount = 1;  ///< 1 of a vertex, 2 of an edge

  [[nodiscard]] std::span<const int> first() const { return {all.data(), firstCount}; }
  [[nodiscard]] std::span<const int> second() const { return {all.data() + firstCount, 4 - firstCount}; }
};

[[nodiscard]] PairVertices verticesOf(const FeatureMesh& mesh, const FeaturePair& pair);

/// The closest points of the features of a pair.
struct PairGap {
  double distance = 0.0;            ///< [m]
  Vec3 normal = Vec3::UnitY();      ///< from the second to the first; the y axis if the distance is 0
  std::array<double, 4> weights{};  ///< of the vertices; positive for the first feature, negative for the second
};

/// Computes the closest points. Slivers are treated as their borders, and nearly parallel edges as parallel ones. So
/// the distance can be slightly too large; `separationAlong` with the normal is a certain lower bound.
[[nodiscard]] PairGap gapOf(const PairVertices& vertices, std::span<const Vec3> positions);

/// The ratio of distances between which the result of comesWithin is not determined [-].
inline constexpr double approachSlack = 1.1;

/// Whether the features of a pair may come closer than `distance` on straight lines from `start` to `end` [m], by
/// conservative advancement (Mirtich 1996). False is certain. The result is false if they stay farther apart than
/// `approachSlack` times `distance`, which must be much larger than the rounding error of the positions.
[[nodiscard]] bool comesWithin(double distance, const PairVertices& vertices, std::span<const Vec3> start,
                               std::span<const Vec3> end);

/// Upper bound of the rounding error of the distance along a unit normal that `extentsOf` gives with the first vertex
/// as origin [m].
[[nodiscard]] double roundingOf(const PairVertices& vertices, std::span<const Vec3> positions);

/// The extents of a pair along a direction, relative to an origin [m].
struct PairExtents {
  double firstLow = 0.0;    ///< minimum of the first feature
  double secondHigh = 0.0;  ///< maximum of the second feature
};

[[nodiscard]] PairExtents extentsOf(const PairVertices& vertices, const Vec3& normal, const Vec3& origin,
                                    std::span<const Vec3> positions);

/// A lower bound, whatever the rounding errors, of the distance of the features along a unit normal: the minimum of the
/// first minus the maximum of the second [m]. If it is positive, a plane with this normal separates them.
[[nodiscard]] double separationAlong(const Vec3& normal, const PairVertices& vertices, std::span<const Vec3> positions);

}  // namespace drape::sim::contact
