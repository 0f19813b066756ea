#pragma once

#include "sim/contact/broad_phase/searchable_mesh.hpp"

#include <limits>
#include <span>

namespace drape::sim::contact {

/// A direction along which points of the cloth are separated from the vertices of some leaves of a mesh.
struct HullGap {
  /// Width of the gap, a lower bound of the distance of the convex hulls [m]; negative: no gap was found.
  double atLeast = -std::numeric_limits<double>::infinity();
  Vec3 normal = Vec3::UnitY();                           ///< towards the cloth
  double top = std::numeric_limits<double>::infinity();  ///< maximum of the leaves along the normal [m]
};

/// Finds the direction of the widest gap between two convex hulls, that of points of the cloth and that of some leaves
/// of a mesh, by the algorithm of Gilbert, Johnson and Keerthi (1988). It works on the differences of their points: in
/// each iteration it adds to a simplex the support point along the offset between the closest points so far, and
/// reduces the simplex to the feature that is closest to the origin. The gap along each direction is measured over all
/// points, so it is valid whenever the search ends.
class HullGapSearch {
 public:
  /// Conditions for ending the search.
  struct Wanted {
    double gap = 0.0;      ///< a gap of this width suffices [m]
    double minimum = 0.0;  ///< a gap of this width suffices if the hulls are closer than `gap` [m]
  };

  /// @param atEnd whether to take the mesh at the end of the step  @param leaves of the mesh's tree, at least one
  /// @param points of the cloth, at least one [m]
  HullGapSearch(const SearchableMesh& mesh, bool atEnd, const std::vector<std::int32_t>& leaves,
                std::span<const Vec3> points)
      : mesh_(mesh), atEnd_(atEnd), leaves_(leaves), points_(points) {}

  /// The widest gap that was found. @param along unit vector with which the search starts, towards the cloth
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
  std::size_t lowest_ = 0;       // support point of the cloth along the last direction
  std::array<Vec3, 4> simplex_;  // offsets from vertices of the mesh to points of the cloth [m]
  std::size_t count_ = 0;        // number of these
  Vec3 offset_ = Vec3::Zero();   // between the closest points so far, from the mesh to the cloth [m]
};

}  // namespace drape::sim::contact
