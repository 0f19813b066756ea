#pragma once

#include "sim/solvers/solver.hpp"
#include "sim/systems/iteration_options.hpp"

#include <cmath>

namespace drape::sim {

/// Solves W dv = b by preconditioned conjugate gradients from dv = 0 (Baraff and Witkin 1998, sec. 5.3), until the
/// residual is below the tolerance relative to b. `system` holds the vectors:
/// - `squaredResidual()`: the squared norm of the residual b - W dv, which is b at first;
/// - `descent()`: the product of the residual and the preconditioned residual;
/// - `multiply()`: multiplies the direction by W and returns the product of both, the curvature;
/// - `descend(length)`: moves dv along the direction and updates the residual;
/// - `turn(factor)`: sets the direction to the preconditioned residual plus the factor times the direction.
template <typename System>
StepReport conjugateGradients(System&& system, const IterationOptions& options) {
  StepReport report;
  const double first = std::sqrt(system.squaredResidual());
  if (!(first > 0.0)) {
    return report;
  }
  report.residual = 1.0;
  double descent = system.descent();
  while (report.iterations < options.maxIterations) {
    const double curvature = system.multiply();
    if (!(curvature > 0.0)) {
      break;  // the matrix is indefinite: there is no minimum along this direction
    }
    system.descend(descent / curvature);
    ++report.iterations;
    report.residual = std::sqrt(system.squaredResidual()) / first;
    if (report.residual <= options.tolerance) {
      break;
    }
    const double next = system.descent();
    system.turn(next / descent);
    descent = next;
  }
  report.converged = report.residual <= options.tolerance;
  return report;
}

}  // namespace drape::sim
