#pragma once

#include "sim/contact/touch.hpp"

#include <span>
#include <vector>

namespace drape {

/// What is asked of a touch: n . q must not be less than `least`, where q is the weighted sum of the vertices' values
/// (positions or velocities), and friction draws q across n towards `still`.
struct TouchGoal {
  double least = 0.0;
  Vec3 still = Vec3::Zero();
};

/// Solves for impulses at touches, one after the other (projected Gauss-Seidel), under Coulomb's law: what acts across
/// a touch is at most the static friction times what acts along its normal; where that does not suffice, it is the
/// kinetic friction times it, against the sliding.
class TouchSolver {
 public:
  /// Changes `values`, one a vertex.
  /// @param inverseMass one a vertex [1/kg]; 0: does not move
  void solve(std::span<const Touch> touches, std::span<const TouchGoal> goals, std::span<const double> inverseMass,
             int rounds, std::span<Vec3> values);

  /// True when the last solve pushed at that touch.
  [[nodiscard]] bool pushed(std::size_t touch) const { return impulses_[touch].along > 0.0; }

 private:
  struct Impulse {
    double along = 0.0;  // [kg times the values' unit]
    Vec3 across = Vec3::Zero();
  };

  std::vector<Impulse> impulses_;
};

}  // namespace drape
