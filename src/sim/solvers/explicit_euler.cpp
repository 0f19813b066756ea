#include "sim/simd/sliced_run.hpp"
#include "sim/solvers/batch_solver.hpp"
#include "sim/solvers/registry.hpp"
#include "sim/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace drape {
namespace {

/// Explicit Euler: x' = x + h v, v' = v + h a(x, v), both from the start of the step.
///
/// It turns x'' = -w^2 x by the matrix [1, h; -h w^2, 1], whose eigenvalues 1 +- i h w are of size sqrt(1 + h^2 w^2) >
/// 1: an undamped oscillator grows by that factor a step, and no step is stable. With x'' = -c x' - w^2 x it is stable
/// up to h = c / w^2 where it still swings (c < 2 w).
///
/// As with Verlet the hand's spring alone is implicit: see applyAttachmentImpulse. The loops stand in
/// simd/verlet_kernel.cpp.
class ExplicitEulerSolver final : public BatchSolver {
 public:
  StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                   ClothState& state) override {
    run_.explicitEuler(model, parameters, inputs, count, state);
    return {};
  }

 private:
  SlicedRun run_;
};

/// A spring that is not compressed is at most k / C_d as stiff in any direction as it is damped, hence so is the whole
/// cloth: c / w^2 >= C_d / k in every mode, with k that of the stiffest spring. The second bound is that of a mode too
/// strongly damped to swing.
double stepLimit(const ClothModel& model, const StepParameters& parameters) {
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  const double swinging = largestFrequency(model, parameters) > 0.0
                              ? parameters.damping / (parameters.stiffness * model.stiffestSpring)
                              : unlimited;
  const double rate = model.unitDampingRate * parameters.damping;
  const double damped = rate > 0.0 ? 2.0 / rate : unlimited;
  return std::min(swinging, damped);
}

std::string explicitEulerWarning(const ClothModel& model, const StepParameters& parameters) {
  const double h = parameters.timeStep / parameters.substeps;
  const double limit = stepLimit(model, parameters);
  if (h <= limit) {
    return {};
  }
  if (limit > 0.0) {
    return stepLimitWarning(parameters, limit);
  }
  // The energy of an undamped mode grows by 1 + h^2 w^2 a step.
  const double growth = std::log1p(std::pow(h * largestFrequency(model, parameters), 2));
  std::ostringstream words;
  words.precision(2);
  words
      << "Explicit Euler gains energy at every step, however short. At this one the cloth's fastest motion doubles its "
         "energy every "
      << h * std::log(2.0) / growth << " s. Take much shorter steps, add damping or choose another solver.";
  return words.str();
}

}  // namespace

SolverInfo solvers::explicitEuler() {
  return {.name = "explicit_euler",
          .title = "Explicit Euler",
          .help =
              "The simplest integrator: position and velocity both go on from the start of the step. One evaluation of "
              "the forces a step and first order; it gains energy at any step unless springs are damped, so it serves "
              "only as a reference with tiny steps (the paper takes 1/30000 s).",
          .source = "Euler (1768), Institutiones calculi integralis",
          .backwardEuler = false,
          .settings = {},
          .warning = explicitEulerWarning,
          .stepLimit = stepLimit,
          .make = []() -> std::unique_ptr<Solver> { return std::make_unique<ExplicitEulerSolver>(); }};
}

}  // namespace drape
