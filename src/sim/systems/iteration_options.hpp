#pragma once

namespace drape::sim {

/// The options of iterative solves. Each solver reads those that it lists (SolverInfo::settings).
struct IterationOptions {
  int iterations = 10;          ///< of methods with a fixed number of iterations [-]
  double spectralRadius = 0.8;  ///< assumed for the Jacobi iteration, for its acceleration [-]
  double tolerance = 1e-6;      ///< relative residual at which a solve ends [-]
  int maxIterations = 1000;     ///< at which a solve gives up [-]
};

}  // namespace drape::sim
