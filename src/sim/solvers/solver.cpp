#include "sim/solvers/solver.hpp"

namespace drape::sim {

StepReport Solver::steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                         ClothState& state) {
  StepReport total;
  for (int i = 0; i < count; ++i) {
    total.add(step(model, parameters, inputs, state));
  }
  return total;
}

}  // namespace drape::sim
