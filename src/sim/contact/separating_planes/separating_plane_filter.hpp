#pragma once

#include "sim/contact/constraints/contact_constraint.hpp"

#include <functional>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// A position that violates a plane by less satisfies it [m]. Far below the minimum separation.
inline constexpr double planeTolerance = 1e-10;

/// Moves every vertex to the permitted side of all its planes and within its displacement bound, which limits the
/// region that was searched.
class SeparatingPlaneFilter {
 public:
  /// A position of a vertex outside a body, in the world frame at the end of the step [m].
  using PositionOf = std::function<Vec3(int body, int vertex)>;

  /// Positions outside the bodies, from which vertices may start.
  struct Fallback {
    PositionOf start;    ///< start of the pass; displacement bounds are measured from here
    PositionOf carried;  ///< the same, moved along with the closest point of a deforming body
  };

  /// Changes `positions`. A vertex without a position that satisfies all its planes gets the one that violates them
  /// least.
  /// @param displacementBounds maximum distance of each vertex from any of its starts [m]
  /// @param bodies number of bodies
  /// @param predicted positions before contact; a vertex that is still there is within the region that was searched
  /// @return number of infeasible vertices
  int apply(std::span<const SeparatingPlane> planes, std::span<const double> inverseMass,
            std::span<const double> displacementBounds, int bodies, const Fallback& fallback,
            std::span<const Vec3> predicted, std::span<Vec3> positions);

  /// The maximum displacement of a vertex by the last call [m].
  [[nodiscard]] double maxCorrection() const { return maxCorrection_; }

 private:
  void sortByVertex(std::span<const SeparatingPlane> planes, std::size_t vertices);
  [[nodiscard]] std::span<const SeparatingPlane> planesOf(std::size_t vertex) const {
    return {sorted_.data() + begin_[vertex], begin_[vertex + 1] - begin_[vertex]};
  }

  double maxCorrection_ = 0.0;
  std::vector<SeparatingPlane> sorted_;  // by vertex; planes of one vertex stay in order
  std::vector<std::size_t> begin_;
};

}  // namespace drape::sim::contact
