#pragma once

#include "sim/contact/constraints/contact_constraint.hpp"

#include <functional>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// A position that violates a plane by at most this distance counts as satisfying it [m]. It is far below the minimum
/// separation.
inline constexpr double planeTolerance = 1e-10;

/// The last stage of contact: moves every vertex to the permitted side of all its planes and within its displacement
/// bound, which limits the region that was searched.
///
/// Each vertex is projected onto the planes that it has crossed, one after the other, at most eight times. If that does
/// not suffice, it moves back along the line towards its fallback position until it violates no plane. If the fallback
/// position itself violates planes, a longer projection from there may find a feasible position.
class SeparatingPlaneFilter {
 public:
  /// A position of a vertex outside a body, in the world frame at the end of the step [m].
  using PositionOf = std::function<Vec3(int body, int vertex)>;

  /// Positions outside the bodies, towards which vertices move back.
  struct Fallback {
    PositionOf start;    ///< start of the pass; displacement bounds are measured from here
    PositionOf carried;  ///< the fallback position: the start, moved along with the closest point of a deforming body
  };

  /// Changes `positions`. A vertex without a position that satisfies all its planes gets the one that violates them
  /// least.
  /// @param displacementBounds maximum distance of each vertex from any of its starts [m]
  /// @param bodies number of bodies
  /// @param predicted positions before contact [m]; a vertex that is still there is within the region that was searched
  /// @param positions solved positions, changed [m]  @return number of infeasible vertices
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
