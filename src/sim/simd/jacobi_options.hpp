#pragma once

namespace drape::sim::simd {

/// The block-Jacobi iteration of `one_iteration`.
struct JacobiOptions {
  int sweeps = 1;           ///< block-Jacobi sweeps of a step [-]; the paper's method has one
  double relaxation = 1.0;  ///< of the sweeps; below 1: damped Jacobi [-]
};

/// The largest relaxation for which an even number of block-Jacobi sweeps is stable. For a mode with Jacobi eigenvalue
/// mu >= -1, k sweeps with relaxation w give g <= 1 + (2 w - 1)^(k+1) times the exact velocity change. A backward-Euler
/// oscillator is stable for g <= 4/3; two sweeps reach that at w = 0.847.
inline constexpr double evenSweepsRelaxation = 0.8;

}  // namespace drape::sim::simd
