#pragma once

#include "sim/simd/sliced_cloth.hpp"

#include <vector>

namespace drape::sim::simd {

/// The number of stages for strong damping in a substep with h lambda = `timesRate`; even.
///
/// Strong damping is split from the other forces. The stages integrate dv/dt = a - D v over a substep h with constant
/// acceleration a and constant positions; for springs D v is C_d / m_i times the sum over springs of v_i - v_j. They
/// are the stages of the first-order Runge-Kutta-Legendre method (Meyer, Balsara and Aslam, 2014, J. Comput. Phys. 257,
/// eqs. 9-12 and 21): s stages are stable up to h lambda = s^2 + s, with lambda the largest eigenvalue of D; s explicit
/// substeps only up to 2 s. The result is a polynomial in D, so momentum is conserved. v = D^-1 a is a fixed point, so
/// overdamped cloth creeps at the right speed.
[[nodiscard]] int dampingStages(double timesRate);

/// The part of the cloth that the stages damp.
enum class DampedPart {
  Springs,   ///< C_d times the sum over springs of v_i - v_j
  Membrane,  ///< stretch and shear of a fabric
  Bending    ///< bending of a fabric, see fabric::BendingDamping
};

/// fabric::BendingDamping in the sliced layout, at the positions of a step.
template <typename T>
struct SlicedBendingDamping {
  std::vector<SliceNumbers<T>> weights;  ///< one a slot; 0 in lanes without a spring [sqrt(N m)]
  LaneArray<T> inverseAreas;             ///< [1/m^2]
  LaneVectors<T> directions;             ///< [-]
  LaneVectors<T> rates;                  ///< d_i (d_i . Delta_i v) / a_i of the velocities of a stage [sqrt(N m)/(m s)]
};

/// The parameters of the stages of one substep.
template <typename T>
struct DampingRun {
  DampedPart part = DampedPart::Springs;
  T timedDamping = 0;  ///< h C_d [N s^2/m] for springs; h times the damping time for a fabric [s^2]
  int stages = 0;      ///< even, so that the last one ends in `velocity`
  /// Scale of each spring's damping [-], one number a slot and lane, 0 without a spring. Null: all are 1.
  const SliceNumbers<T>* dampingScales = nullptr;
  /// Receives h a [m/s] in the first stage, for the others. Null: a = 0, and only `velocity` counts before the first
  /// stage.
  LaneVectors<T>* gain = nullptr;
  SlicedBendingDamping<T>* bending = nullptr;  ///< for DampedPart::Bending
};

/// Computes the rates of bending that the stage damps, for the slices of one thread. All threads must have finished
/// before `dampingStage`.
void bendingRates(SlicedCloth<float>& cloth, const DampingRun<float>& run, int stage, const StepShare& share);
void bendingRates(SlicedCloth<double>& cloth, const DampingRun<double>& run, int stage, const StepShare& share);

/// One stage, counted from 1, for the slices of one thread. Before the first stage `velocity` has the velocities before
/// the kick and `start` those after it. Each stage reads one of them and writes the other.
void dampingStage(SlicedCloth<float>& cloth, const DampingRun<float>& run, int stage, const StepShare& share);
void dampingStage(SlicedCloth<double>& cloth, const DampingRun<double>& run, int stage, const StepShare& share);

}  // namespace drape::sim::simd
