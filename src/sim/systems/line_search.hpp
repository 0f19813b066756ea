#pragma once

#include "sim/model/vector.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace drape::sim {

/// The result of evaluating a potential. Pinned vertices do not count.
struct PotentialValue {
  double value = 0.0;          ///< of the potential [J]
  double valueRounding = 0.0;  ///< bound of its rounding error [J]
  double residual = 0.0;       ///< norm of the gradient [unit of the gradient]
  double rounding = 0.0;       ///< smallest residual that rounding allows [unit of the gradient]
};

/// The line search of Newton's method with backtracking (Nocedal and Wright, Numerical Optimization, algorithm 3.1):
/// takes the largest fraction 1, 1/2, 1/4, ... of the direction that lowers the potential enough. If the potential
/// changes by less than its rounding error, the residual decides. Returns false if no fraction is accepted; the point
/// then stays, and the potential is evaluated there again.
/// @param evaluate   computes the PotentialValue at a point
/// @param direction  one vector a vertex [unit of the point]
/// @param slope      of the potential along the direction [J], negative
/// @param point      where `current` was evaluated; moves to the accepted point
/// @param current    the value there
/// @param trial      scratch memory, as long as the point
template <typename Evaluate>
bool searchLine(const Evaluate& evaluate, const std::vector<Vec3>& direction, double slope, std::vector<Vec3>& point,
                PotentialValue& current, std::vector<Vec3>& trial) {
  constexpr double sufficientDecrease = 1e-4;  // fraction of the decrease predicted by the slope (Armijo's condition)
  constexpr int maxHalvings = 30;              // shorter steps have no effect
  double fraction = 1.0;
  for (int halving = 0; halving <= maxHalvings; ++halving, fraction *= 0.5) {
    for (std::size_t i = 0; i < point.size(); ++i) {
      trial[i] = point[i] + fraction * direction[i];
    }
    const PotentialValue value = evaluate(trial);
    const double change = value.value - current.value;
    const bool lower = change <= sufficientDecrease * fraction * slope && change < -current.valueRounding;
    const bool level = std::abs(change) <= current.valueRounding && value.residual < current.residual;
    if (lower || level) {
      current = value;
      point.swap(trial);
      return true;
    }
  }
  current = evaluate(point);
  return false;
}

}  // namespace drape::sim
