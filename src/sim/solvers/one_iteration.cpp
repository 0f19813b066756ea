#include "sim/implicit_system.hpp"
#include "sim/solvers/one_iteration_limits.hpp"
#include "sim/solvers/registry.hpp"

#include <Eigen/LU>

namespace drape {
namespace {

/// The one-iteration implicit mass-spring step: backward Euler, solved by `sweeps` block-Jacobi sweeps from
/// p_i = h W_ii^-1 f~_i. One sweep is eq. 11, the paper's method:
///
///     dv_i = p_i + h^2 W_ii^-1 sum_j J_ij p_j
///
/// With an eigenvalue mu of the Jacobi iteration, k sweeps give 1 - mu^(k+1) of the exact answer's mode. For odd k that
/// stays within 0 and 1, for even k it can reach 2. A relaxation w < 1 (damped Jacobi, the step from one sweep's answer
/// to the next's taken by w only) moves mu to 1 - w (1 - mu), which makes even counts harmless; see evenSweepsAllowed.
class OneIterationSolver final : public Solver {
 public:
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) override {
    const std::size_t count = state.positions.size();
    system_.assemble(model, parameters, inputs, state, workers_);
    inverse_.resize(count);
    p_.resize(count);
    dv_.resize(count);
    next_.resize(count);
    workers_.forEach(parameters.threads, count, [&](std::size_t i) { start(model, parameters, i); });
    for (int sweep = 0; sweep < parameters.sweeps; ++sweep) {
      workers_.forEach(parameters.threads, count, [&](std::size_t i) { relax(model, parameters, i); });
      dv_.swap(next_);
    }
    advance(model, parameters.timeStep, dv_, state);
    return {};
  }

 private:
  /// p_i = h W_ii^-1 f~_i, the start of the sweeps. A pinned vertex has no velocity to gain.
  void start(const ClothModel& model, const StepParameters& parameters, std::size_t i) {
    inverse_[i] = model.pinned[i] ? Mat3(Mat3::Zero()) : Mat3(system_.diagonal()[i].inverse());
    p_[i] = inverse_[i] * system_.rightHandSide()[i];
    dv_[i] = parameters.relaxation * p_[i];
  }

  /// dv_i = p_i + h^2 W_ii^-1 sum_j J'_ij dv_j (eqs. 11, 13), or the way there by the relaxation.
  void relax(const ClothModel& model, const StepParameters& parameters, std::size_t i) {
    const Vec3 answer = p_[i] + inverse_[i] * system_.coupling(model, parameters, dv_, i);
    next_[i] = parameters.relaxation == 1.0 ? answer : Vec3(dv_[i] + parameters.relaxation * (answer - dv_[i]));
  }

  Workers workers_;
  ImplicitSystem system_;
  std::vector<Mat3> inverse_;  // W'_ii^-1, one a vertex [1/kg]; zero where pinned
  std::vector<Vec3> p_;        // [m/s]
  std::vector<Vec3> dv_;       // velocity change of the last sweep [m/s]
  std::vector<Vec3> next_;     // [m/s]
};

}  // namespace

SolverInfo solvers::oneIteration() {
  return {
      .name = "one_iteration",
      .title = "One iteration (implicit)",
      .help =
          "The paper's method: backward Euler with one block-Jacobi sweep a step and a force derivative that is "
          "stabilised where springs are compressed. The cheapest implicit step after kang's, and calm at large steps "
          "on coarse cloth. Stiff cloth turns slack and sluggish, free cloth loses momentum, and flat cloth that is "
          "fine and stiff can gain energy and blow up; substeps cure all of it better than sweeps.",
      .source = "Kang and co-authors (the paper; its full citation was not at hand)",
      .backwardEuler = true,
      .settings = {"sweeps", "relaxation", "derivative"},
      .warning = oneIterationWarning,
      .stepLimit = nullptr,
      .make = []() -> std::unique_ptr<Solver> { return std::make_unique<OneIterationSolver>(); }};
}

}  // namespace drape
