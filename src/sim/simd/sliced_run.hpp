#pragma once

#include "sim/simd/slice_step.hpp"
#include "sim/simd/sliced_cloth_cache.hpp"
#include "sim/simd/thread_team.hpp"

#include <vector>

namespace drape {

/// Runs steps on a cloth that is laid out for vector instructions, in the precision and with the threads that the
/// parameters ask for. The state is converted once for all of them.
class SlicedRun {
 public:
  /// Steps of the one-iteration method with `parameters.sweeps` sweeps. `weights` of Chebyshev's acceleration, one a
  /// sweep, may be empty.
  void oneIteration(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                    const std::vector<double>& weights, ClothState& state);

  /// Steps of Stoermer-Verlet.
  void verlet(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
              ClothState& state);

  /// Steps of explicit Euler, in double whatever the parameters ask for: it is for steps so short that in float most of
  /// each would be lost to rounding.
  void explicitEuler(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                     ClothState& state);

 private:
  template <typename T>
  void oneIteration(const ClothModel& model, SlicedCloth<T>& cloth, const StepParameters& parameters,
                    const StepInputs& inputs, int count, const std::vector<double>& weights, ClothState& state);
  template <typename T>
  void verlet(const ClothModel& model, SlicedCloth<T>& cloth, const StepParameters& parameters,
              const StepInputs& inputs, int count, ClothState& state);

  ThreadTeam team_;
  SlicedClothCache<float> single_;
  SlicedClothCache<double> double_;
};

}  // namespace drape
