#pragma once

namespace drape::sim {

/// The derivative of a spring's force in the matrix of implicit methods (docs/theory/method.md compares them).
enum class ForceDerivative {
  Stabilised,  ///< the paper's eq. 16: exact when stretched, k (l0/L) d d^T when compressed
  Exact,       ///< the paper's eq. 15: k [(1 - l0/L) I + (l0/L) d d^T]; indefinite when compressed
  Scalar,      ///< k I, as Desbrun, Schroeder and Barr (1999)
  Axial,       ///< k d d^T, as Volino and Magnenat-Thalmann
  TensionOnly  ///< exact when stretched, nothing when compressed, as Choi and Ko (2002)
};

}  // namespace drape::sim
