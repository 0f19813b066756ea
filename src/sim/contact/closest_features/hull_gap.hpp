#pragma once

#include "sim/contact/broad_phase/searchable_mesh.hpp"

#include <limits>
#include <span>

namespace drape::sim::contact {

/// A direction along which points of the cloth are separated from the vertices of some leaves of a mesh.
struct HullGap {
  double atLeast = -std::numeric_limits<double>::infinity();  ///< width of the gap [m]; negative: they overlap
  Vec3 normal = Vec3::UnitY();                                ///< towards the cloth
  double top = std::numeric_limits<double>::infinity();       ///< maximum of the leaves along the normal [m]
};

/// Finds the direction of the widest gap between two convex hulls by the algorithm of Gilbert, Johnson and Keerthi
/// (1988): it adds the support points along the offset between the closest points so far to a simplex. Each gap is
/// measured over all points, so it is valid wherever the search ends.
class HullGapSearch {
 public:
  /// Conditions for ending the search [m].
  struct Wanted {
    double gap = 0.0;      ///< a gap that wide suffices
    double minimum = 0.0;  ///< a gap that wide suffices if the hulls are closer than `gap`
  };

  /// @param leaves leaves of the mesh's tree, at least one  @param points at least one [m]
  HullGapSearch(const SearchableMesh& mesh, bool atEnd, const std::vector<std::int32_t>& leaves,
                std::span<const Vec3> points)
      : mesh_(mesh), atEnd_(atEnd), leaves_(leaves), points_(points) {}

  /// Starts with the gap along a unit vector.
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
  std::size_t lowest_ = 0;  // support point of the cloth along the last direction
  std::array<Vec3, 4> simplex_;
  std::size_t count_ = 0;
  Vec3 offset_ = Vec3::Zero();  // between the closest points so far, from the mesh to the cloth [m]
};

}  // namespace drape::sim::contact
