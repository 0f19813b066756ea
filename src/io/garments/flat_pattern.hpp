#pragma once

#include "io/mesh_import.hpp"
#include "sim/vector.hpp"

#include <functional>
#include <vector>

namespace drape {

/// A closed line around a piece of cloth, counter-clockwise, as points about an edge length apart.
class Outline {
 public:
  /// Starts at a point; `edgeLength` is the distance between points [m].
  Outline(const Vec2& start, double edgeLength) : points_{start}, edgeLength_(edgeLength) {}

  /// Goes straight to a point. `sewn` tells that another piece is sewn on here.
  void lineTo(const Vec2& end, bool sewn);

  /// Goes along curve(0) .. curve(1), which starts where the outline is now.
  void curveTo(const std::function<Vec2(double)>& curve, bool sewn);

  /// The points without the last one, which is the first again.
  [[nodiscard]] std::vector<Vec2> points() const;

  /// For each point whether it is on a stretch that is sewn on.
  [[nodiscard]] std::vector<bool> sewn() const;

 private:
  std::vector<Vec2> points_;
  std::vector<bool> stretchSewn_;  ///< one for each stretch between two points
  double edgeLength_;
};

/// Points about an edge length apart along curve(0) .. curve(1), both ends included.
[[nodiscard]] std::vector<Vec2> sampleCurve(const std::function<Vec2(double)>& curve, double edgeLength);

/// Whether a point lies inside a closed line.
[[nodiscard]] bool isInside(const std::vector<Vec2>& outline, const Vec2& point);

/// A piece of cloth on the table.
struct FlatPattern {
  std::vector<Vec2> outline;             ///< counter-clockwise
  std::vector<std::vector<Vec2>> lines;  ///< inner lines that edges shall follow
};

/// A triangulated piece of cloth on the table. The outline's points come first, then those of the inner lines.
struct FlatMesh {
  std::vector<Vec2> points;         ///< [m]
  std::vector<Triangle> triangles;  ///< counter-clockwise
};

/// Fills a pattern with triangles that are as equilateral as its outline allows, in a lattice symmetric to x = 0.
[[nodiscard]] FlatMesh meshPattern(const FlatPattern& pattern, double edgeLength);

/// Adds a triangulated piece to a garment. `position` places each of its points in space [m]; `chart` says for each of
/// its triangles how far its texture coordinates, which are the points themselves, are moved aside: triangles moved
/// differently share no texture vertices.
void addPiece(const FlatMesh& piece, const std::vector<Vec3>& position, const std::vector<Vec2>& chart,
              RawMesh& garment);

}  // namespace drape
