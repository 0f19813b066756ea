#include "sim/solvers/assembled_run.hpp"
#include "sim/solvers/batch_solver.hpp"
#include "sim/solvers/conjugate_gradients_run.hpp"
#include "sim/solvers/registry.hpp"

namespace drape::sim {
namespace {

/// The modified conjugate gradient method of Baraff and Witkin (1998, sec. 5.3) on the system of the one-iteration
/// method, with the 3x3 diagonal blocks as preconditioner. Pins are constraints of its filter: the rows of a pinned
/// vertex are left out, and its velocity change is zero. The loops are in simd/conjugate_gradients_kernel.cpp.
class PcgSolver final : public BatchSolver {
 public:
  StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                   ClothState& state) override {
    return model.fabric ? assembled_.conjugateGradients(model, parameters, inputs, count, state)
                        : run_.steps(model, parameters, inputs, count, state);
  }

 private:
  ConjugateGradientsRun run_;
  AssembledRun assembled_;  // of fabrics
};

}  // namespace

SolverInfo solvers::pcg() {
  return {
      .name = "pcg",
      .title = "Conjugate gradients",
      .help =
          "Backward Euler. Preconditioned conjugate gradients solve the linear system to the tolerance. This is the "
          "solution that the one-iteration method approximates. Stable at every time step and stiffness that was "
          "tested. A step costs tens to thousands of sweeps, more for stiff and fine cloth. With the exact derivative "
          "the system of compressed cloth may be indefinite; the iteration then stops early.",
      .source = "Baraff and Witkin (1998), Large steps in cloth simulation",
      .backwardEuler = true,
      .takesFabric = true,
      .settings = {"tolerance", "max_iterations", "derivative", "precision"},
      .warning = nullptr,
      .make = []() -> std::unique_ptr<Solver> { return std::make_unique<PcgSolver>(); }};
}

}  // namespace drape::sim
