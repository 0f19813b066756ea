#pragma once

#include "sim/model/model_cache.hpp"
#include "sim/simd/conjugate_gradients.hpp"
#include "sim/simd/sliced_cloth_cache.hpp"
#include "sim/simd/thread_team.hpp"
#include "sim/solvers/solver.hpp"

#include <memory>

namespace drape::sim {

/// Runs backward-Euler steps with conjugate gradients on a sliced cloth, in the precision and with the threads of the
/// parameters. The state is converted once for all steps.
class ConjugateGradientsRun {
 public:
  StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                   ClothState& state);

 private:
  template <typename T>
  struct Memory {
    simd::SlicedClothCache<T> cloths;
    ModelCache<simd::ConjugateGradients<T>> systems;
  };

  template <typename T>
  StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                   Memory<T>& memory, ClothState& state);

  simd::ThreadTeam team_;
  Memory<float> single_;
  Memory<double> double_;
};

}  // namespace drape::sim
