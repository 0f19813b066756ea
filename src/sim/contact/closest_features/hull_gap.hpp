#pragma once

#include "sim/contact/broad_phase/searchable_mesh.hpp"

#include <limits>
#include <span>

namespace drape {

/// A direction in which a few points of the cloth lie above all vertices of some leaves of a mesh.
struct HullGap {
  double atLeast = -std::numeric_limits<double>::infinity();  ///< by how much [m]; negative: they lie deeper
  Vec3 normal = Vec3::UnitY();                                ///< towards the cloth
  double top = std::numeric_limits<double>::infinity();       ///< of the leaves along the normal [m]
};

/// Looks for the direction with the widest gap between two convex hulls, by the algorithm of Gilbert, Johnson and
/// Keerthi (1988): from the nearest pair of points found so far to what of both sticks out farthest along the way
/// between them. A gap is measured over all points, so it is one however the search ends.
class HullGapSearch {
 public:
  /// When the search ends [m].
  struct Wanted {
    double gap = 0.0;      ///< one that wide is enough
    double minimum = 0.0;  ///< where there is none that wide, this does
  };

  /// @param leaves leaves of the mesh's tree, at least one  @param points at least one [m]
  HullGapSearch(const SearchableMesh& mesh, bool atEnd, const std::vector<std::int32_t>& leaves,
                std::span<const Vec3> points)
      : mesh_(mesh), atEnd_(atEnd), leaves_(leaves), points_(points) {}

  /// Measures the gap along a unit vector, and goes on from there.
  HullGap search(const Vec3& along, const Wanted& wanted);

 private:
  SupportPoint measure(const Vec3& along);
  void add(const SupportPoint& far);
  bool reduce();

  const SearchableMesh& mesh_;
  bool atEnd_;
  const std::vector<std::int32_t>& leaves_;
  std::span<const Vec3> points_;
  HullGap best_;
  std::size_t lowest_ = 0;  // of the points along the last direction
  std::array<Vec3, 4> simplex_;
  std::size_t count_ = 0;
  Vec3 offset_ = Vec3::Zero();  // from the mesh to the cloth, between the nearest points so far [m]
};

}  // namespace drape
