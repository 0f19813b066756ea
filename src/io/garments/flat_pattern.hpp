#pragma once

#include "io/mesh_import.hpp"
#include "sim/model/vector.hpp"

#include <functional>
#include <vector>

namespace drape::io {

/// A closed outline of a piece of cloth, counter-clockwise, as points about an edge length apart.
class Outline {
 public:
  /// Starts at a point; `edgeLength` is the distance between points [m].
  Outline(const Vec2& start, double edgeLength) : points_{start}, edgeLength_(edgeLength) {}

  /// Adds a straight line to a point. `sewn` marks a seam with another piece.
  void lineTo(const Vec2& end, bool sewn);

  /// Adds the curve from curve(0), the current point, to curve(1).
  void curveTo(const std::function<Vec2(double)>& curve, bool sewn);

  /// The points without the last one, which equals the first.
  [[nodiscard]] std::vector<Vec2> points() const;

  /// Whether each point is on a seam.
  [[nodiscard]] std::vector<bool> sewn() const;

 private:
  std::vector<Vec2> points_;
  std::vector<bool> stretchSewn_;  ///< one per segment between two points
  double edgeLength_;
};

/// Points about an edge length apart along curve(0) .. curve(1), both ends included.
[[nodiscard]] std::vector<Vec2> sampleCurve(const std::function<Vec2(double)>& curve, double edgeLength);

/// Whether a point lies inside a closed line.
[[nodiscard]] bool isInside(const std::vector<Vec2>& outline, const Vec2& point);

/// The pattern of a piece of cloth in the plane.
struct FlatPattern {
  std::vector<Vec2> outline;             ///< counter-clockwise
  std::vector<std::vector<Vec2>> lines;  ///< inner lines that edges follow
};

/// A triangulated piece of cloth in the plane. The points of the outline come first, then those of the inner lines.
struct FlatMesh {
  std::vector<Vec2> points;         ///< [m]
  std::vector<Triangle> triangles;  ///< counter-clockwise
};

/// Fills a pattern with nearly equilateral triangles, in a lattice symmetric to x = 0.
[[nodiscard]] FlatMesh meshPattern(const FlatPattern& pattern, double edgeLength);

/// Adds a triangulated piece to a garment. `position` gives each of its points in space [m]. The texture coordinates of
/// a triangle are its points, shifted by its entry in `chart`: triangles with different shifts share no texture
/// vertices.
void addPiece(const FlatMesh& piece, const std::vector<Vec3>& position, const std::vector<Vec2>& chart,
              RawMesh& garment);

}  // namespace drape::io
