#pragma once

#include "sim/simd/jacobi_options.hpp"
#include "sim/simd/slice_step.hpp"
#include "sim/simd/sliced_cloth_cache.hpp"
#include "sim/simd/thread_team.hpp"

#include <vector>

namespace drape::sim::simd {

/// Runs steps on a sliced cloth, in the precision and with the threads of the parameters. The state is converted once
/// for all steps.
class SlicedRun {
 public:
  /// Steps of the one-iteration method with `jacobi.sweeps` sweeps. `weights` of Chebyshev's acceleration, one a
  /// sweep, may be empty.
  void oneIteration(const ClothModel& model, const CommonParameters& parameters, const JacobiOptions& jacobi,
                    const StepInputs& inputs, int count, const std::vector<double>& weights, ClothState& state);

  /// Steps of Stoermer-Verlet.
  void verlet(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs, int count,
              ClothState& state);

  /// Steps of explicit Euler, always in double: its steps are so short that float would lose most of each to rounding.
  void explicitEuler(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs, int count,
                     ClothState& state);

 private:
  template <typename T>
  void oneIteration(const ClothModel& model, SlicedCloth<T>& cloth, const CommonParameters& parameters,
                    const JacobiOptions& jacobi, const StepInputs& inputs, int count,
                    const std::vector<double>& weights, ClothState& state);
  template <typename T>
  void verlet(const ClothModel& model, SlicedCloth<T>& cloth, const CommonParameters& parameters,
              const StepInputs& inputs, int count, ClothState& state);

  ThreadTeam team_;
  SlicedClothCache<float> single_;
  SlicedClothCache<double> double_;
};

}  // namespace drape::sim::simd
