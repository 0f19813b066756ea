#include "sim/simd/sliced_run.hpp"
#include "sim/solvers/assembled_run.hpp"
#include "sim/solvers/batch_solver.hpp"
#include "sim/solvers/one_iteration_limits.hpp"
#include "sim/solvers/registry.hpp"

namespace drape::sim {
namespace {

/// The one-iteration implicit mass-spring step: backward Euler, solved by `sweeps` block-Jacobi sweeps from
/// p_i = h W_ii^-1 f~_i. One sweep is eq. 11, the paper's method:
///
///     dv_i = p_i + h^2 W_ii^-1 sum_j J_ij p_j
///
/// In a mode with Jacobi eigenvalue mu, k sweeps give 1 - mu^(k+1) of the exact answer. For odd k that is between 0 and
/// 1, for even k it can reach 2. A relaxation w < 1 (damped Jacobi: each sweep changes the answer by w times the full
/// change) replaces mu by 1 - w (1 - mu), which makes even numbers of sweeps stable.
///
/// The equations are in simd/one_iteration_kernel.cpp.
class OneIterationSolver final : public BatchSolver {
 public:
  StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                   ClothState& state) override {
    if (model.fabric) {
      assembled_.oneIteration(model, parameters, parameters.jacobi, inputs, count, {}, state);
    } else {
      run_.oneIteration(model, parameters, parameters.jacobi, inputs, count, {}, state);
    }
    return {};
  }

 private:
  simd::SlicedRun run_;
  AssembledRun assembled_;  // of fabrics
};

}  // namespace

SolverInfo solvers::oneIteration() {
  return {
      .name = "one_iteration",
      .title = "One iteration (implicit)",
      .help =
          "The paper's method: backward Euler with one block-Jacobi sweep a step and a force derivative that is "
          "stabilised for compressed springs. The cheapest implicit step after kang, stable at large steps on coarse "
          "cloth. Stiff cloth becomes slack and slow, free cloth loses momentum, and flat cloth that is fine and stiff "
          "can gain energy and blow up. Substeps help more than sweeps.",
      .source = "Real-Time Animation of Complex Virtual Cloth with Physical Plausibility and Numerical Stability",
      .backwardEuler = true,
      .takesFabric = true,
      .settings = {"sweeps", "relaxation", "derivative", "precision"},
      .warning = oneIterationWarning,
      .stepLimit = nullptr,
      .make = []() -> std::unique_ptr<Solver> { return std::make_unique<OneIterationSolver>(); }};
}

}  // namespace drape::sim
