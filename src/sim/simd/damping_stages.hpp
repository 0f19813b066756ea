#pragma once

#include "sim/simd/sliced_cloth.hpp"

namespace drape {

/// How strong damping is taken by itself, in stages between which velocities alone change: dv/dt = a - D v over a
/// substep h, with D v = C_d / m_i times the sum over springs of v_i - v_j, and the acceleration a held. These are the
/// stages of the first-order Runge-Kutta-Legendre method (Meyer, Balsara and Aslam, 2014, J. Comput. Phys. 257, eqs.
/// 9-12 and 21): s of them are stable to h lambda = s^2 + s, with lambda the largest rate of D, where s explicit
/// substeps would be to 2 s. Each is a polynomial in D, so momentum is kept; and v = D^-1 a stays as it is, so that
/// cloth that creeps does so at the right speed.
[[nodiscard]] int dampingStages(double timesRate);

/// What the stages of one substep have in common.
template <typename T>
struct DampingRun {
  T timedDamping = 0;  ///< h C_d [N s^2/m]
  int stages = 0;      ///< even, so that the last one ends in `velocity`
  /// The share of its damping that each spring keeps, one number a slot and lane, 0 where there is none. Null: all.
  const SliceNumbers<T>* shares = nullptr;
  LaneVectors<T>* gain = nullptr;  ///< takes h a [m/s] in the first stage, for the others
};

/// One stage, counted from 1, for the slices of one thread. The first finds the velocity from before the kick in
/// `velocity` and that from after it in `start`; each reads one of these and writes the other.
void dampingStage(SlicedCloth<float>& cloth, const DampingRun<float>& run, int stage, const StepShare& share);
void dampingStage(SlicedCloth<double>& cloth, const DampingRun<double>& run, int stage, const StepShare& share);

}  // namespace drape
