#include "sim/forces/stability.hpp"
#include "sim/simd/sliced_run.hpp"
#include "sim/solvers/batch_solver.hpp"
#include "sim/solvers/common_warnings.hpp"
#include "sim/solvers/registry.hpp"

namespace drape::sim {
namespace {

/// Stoermer-Verlet in its position form (drift, kick, drift), one evaluation of the forces a step:
///
///     x_m = x + h/2 v,   v' = v + h a(x_m, v),   x' = x_m + h/2 v'
///
/// Symplectic, time-reversible and of second order for forces that depend on positions. Damping and air use the
/// velocity at the start of the step. So the step is explicit, and of first order in these forces.
///
/// The attachment's spring can be far stiffer than the cloth, so it is implicit: see applyAttachmentImpulse. The loops
/// are in simd/verlet_kernel.cpp.
class VerletSolver final : public BatchSolver {
 public:
  StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                   ClothState& state) override {
    run_.verlet(model, parameters, inputs, count, state);
    return {};
  }

 private:
  simd::SlicedRun run_;
};

std::optional<SolverWarning> verletWarning(const ClothModel& model, const StepParameters& parameters) {
  return stepLimitWarning(parameters, verletStepLimit(model, parameters));
}

}  // namespace

SolverInfo solvers::verlet() {
  return {
      .name = "verlet",
      .title = "Verlet (explicit)",
      .help =
          "Stoermer-Verlet: symplectic, of second order, with one force evaluation a step. The most accurate method "
          "for its cost while the step is below the stability limit of the mesh. Above the limit the cloth blows up. "
          "Stiff or fine cloth has a low limit.",
      .source = "Stoermer, 1907; Verlet, 1967, Computer experiments on classical fluids",
      .backwardEuler = false,
      .takesFabric = true,
      .settings = {"precision"},
      .warning = verletWarning,
      .stepLimit = verletStepLimit,
      .make = []() -> std::unique_ptr<Solver> { return std::make_unique<VerletSolver>(); }};
}

}  // namespace drape::sim
