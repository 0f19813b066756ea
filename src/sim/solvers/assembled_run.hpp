#pragma once

#include "sim/simd/jacobi_options.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/systems/implicit_system.hpp"

#include <vector>

namespace drape::sim {

/// Runs backward-Euler steps on an ImplicitSystem, in double and without vector instructions. The implicit solvers use
/// it for cloth with a fabric.
class AssembledRun {
 public:
  /// Takes `count` steps of the one-iteration method with `jacobi.sweeps` block-Jacobi sweeps, as
  /// SlicedRun::oneIteration does for springs.
  /// @param weights of Chebyshev's acceleration, one a sweep; empty: plain sweeps
  void oneIteration(const ClothModel& model, const CommonParameters& parameters, const simd::JacobiOptions& jacobi,
                    const StepInputs& inputs, int count, const std::vector<double>& weights, ClothState& state);

  /// Takes `count` steps with conjugate gradients, as ConjugateGradientsRun::steps does for springs.
  StepReport conjugateGradients(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                                int count, ClothState& state);

 private:
  struct ConjugateVectors;

  void assemble(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs,
                const ClothState& state, bool withSurplus);
  void sweep(const ClothModel& model, const CommonParameters& parameters, const simd::JacobiOptions& jacobi, int sweep,
             const std::vector<double>& weights);
  StepReport solve(const ClothModel& model, const StepParameters& parameters);

  Workers workers_;
  ImplicitSystem system_;
  std::vector<Mat3> inverses_;   // of the diagonal blocks, with their surplus for Jacobi [1/kg]; zero where pinned
  std::vector<Vec3> start_;      // the inverses times h f~ [m/s]
  std::vector<Vec3> change_;     // dv [m/s]
  std::vector<Vec3> before_;     // dv of the sweep before [m/s]
  std::vector<Vec3> residual_;   // [N s]
  std::vector<Vec3> scaled_;     // the inverses times the residual [m/s]
  std::vector<Vec3> direction_;  // [m/s]
  std::vector<Vec3> product_;    // W times the direction [N s]
};

}  // namespace drape::sim
