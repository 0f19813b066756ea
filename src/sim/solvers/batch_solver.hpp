#pragma once

#include "sim/solver.hpp"

namespace drape {

/// A solver that takes its steps in batches, since it keeps the cloth in a form of its own: one step is a batch of one.
class BatchSolver : public Solver {
 public:
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) final {
    return steps(model, parameters, inputs, 1, state);
  }

  StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                   ClothState& state) override = 0;
};

}  // namespace drape
