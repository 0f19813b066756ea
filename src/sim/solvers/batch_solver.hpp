#pragma once

#include "sim/solvers/solver.hpp"

namespace drape::sim {

/// A solver that takes steps in batches, because it converts the state to its own data layout. One step is a batch of
/// one.
class BatchSolver : public Solver {
 public:
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) final {
    return steps(model, parameters, inputs, 1, state);
  }

  StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                   ClothState& state) override = 0;
};

}  // namespace drape::sim
