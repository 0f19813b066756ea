#include "sim/forces/stability.hpp"
#include "sim/simd/sliced_run.hpp"
#include "sim/solvers/batch_solver.hpp"
#include "sim/solvers/common_warnings.hpp"
#include "sim/solvers/registry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape::sim {
namespace {

/// Explicit Euler: x' = x + h v, v' = v + h a(x, v), both from the start of the step.
///
/// A step of x'' = -w^2 x is the matrix [1, h; -h w^2, 1]. Its eigenvalues 1 +- i h w have the size sqrt(1 + h^2 w^2) >
/// 1: an undamped oscillator grows by that factor in each step, so no step is stable. x'' = -c x' - w^2 x is stable up
/// to h = c / w^2 if it is underdamped (c < 2 w).
///
/// As with Verlet, only the attachment's spring is implicit: see applyAttachmentImpulse. The loops are in
/// simd/verlet_kernel.cpp.
class ExplicitEulerSolver final : public BatchSolver {
 public:
  StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                   ClothState& state) override {
    run_.explicitEuler(model, parameters, inputs, count, state);
    return {};
  }

 private:
  simd::SlicedRun run_;
};

/// The stiffness of an uncompressed spring in any direction is at most k / C_d times its damping. This holds for the
/// whole cloth: c / w^2 >= C_d / k in every mode, with k of the stiffest spring. The second bound is that of an
/// overdamped mode.
double stepLimit(const ClothModel& model, const CommonParameters& parameters) {
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  const auto [stiffness, damping] = actingMaterial(model, parameters);
  const bool swings = largestFrequency(model, parameters) > 0.0;
  if (swings && damping == 0.0) {
    return 0.0;
  }
  const double swinging = swings ? damping / (stiffness * model.stiffestSpring) : unlimited;
  const double rate = model.unitDampingRate * damping;
  const double damped = rate > 0.0 ? 2.0 / rate : unlimited;
  return std::min(swinging, damped);
}

std::optional<SolverWarning> explicitEulerWarning(const ClothModel& model, const StepParameters& parameters) {
  const double h = parameters.timeStep / parameters.substeps;
  const double limit = stepLimit(model, parameters);
  if (h <= limit) {
    return std::nullopt;
  }
  if (limit > 0.0) {
    return stepLimitWarning(parameters, limit);
  }
  // The energy of an undamped mode grows by 1 + h^2 w^2 a step.
  const double growth = std::log1p(std::pow(h * largestFrequency(model, parameters), 2));
  return SolverWarning{.kind = SolverWarning::Kind::GainsEnergy, .seconds = h * std::log(2.0) / growth};
}

}  // namespace

SolverInfo solvers::explicitEuler() {
  return {.name = "explicit_euler",
          .title = "Explicit Euler",
          .help =
              "The simplest integrator, of first order, with one force evaluation a step. Position and velocity are "
              "extrapolated from the start of the step. Without damping it gains energy at any step, so it serves only "
              "as a reference with tiny steps (1/30000 s in the paper).",
          .source = "Euler (1768), Institutiones calculi integralis",
          .backwardEuler = false,
          .takesFabric = true,
          .settings = {},
          .warning = explicitEulerWarning,
          .stepLimit = stepLimit,
          .make = []() -> std::unique_ptr<Solver> { return std::make_unique<ExplicitEulerSolver>(); }};
}

}  // namespace drape::sim
