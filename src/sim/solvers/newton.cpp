#include "sim/model/model_cache.hpp"
#include "sim/solvers/registry.hpp"
#include "sim/systems/incremental_potential.hpp"
#include "sim/systems/line_search.hpp"
#include "sim/systems/sparse_system.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <memory>

namespace drape::sim {
namespace {

/// The Cholesky factorisation of a cloth's Hessian. Ordering and pattern are computed once for a model.
struct Factorisation {
  explicit Factorisation(const ClothModel& model) : hessian(model) {
    if (hessian.lower().rows() > 0) {
      cholesky.analyzePattern(hessian.lower());
    }
  }
  SparseSystem hessian;
  Eigen::SimplicialLLT<SparseSystem::Matrix, Eigen::Lower> cholesky;
};

/// Converged backward Euler: Newton's method with a line search on the incremental potential (Gast et al. 2015 for the
/// potential; Nocedal and Wright, Numerical Optimization, algorithms 3.1 and 3.2).
///
/// It starts from zero velocities, that is, from the positions at the start of the step. If the line search accepts the
/// full first step, the first iterate is the linearised step of Baraff and Witkin (1998), W dv = h f~.
///
/// A step has converged when its residual is below the tolerance, relative to that of zero velocities, or when rounding
/// prevents further decrease.
class NewtonSolver final : public Solver {
 public:
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) override {
    factorisation_ = cache_.get(model, [](const ClothModel& m) { return std::make_unique<Factorisation>(m); }).get();
    potential_.prepare(model, parameters, inputs, state, workers_);
    const StepReport report = minimise(parameters, inputs, state.positions.size());
    for (std::size_t i = 0; i < velocities_.size(); ++i) {
      state.velocities[i] = velocities_[i];
      state.positions[i] += parameters.timeStep * velocities_[i];
    }
    state.time += parameters.timeStep;
    return report;
  }

 private:
  StepReport minimise(const StepParameters& parameters, const StepInputs& inputs, std::size_t count) {
    velocities_.assign(count, Vec3::Zero());
    direction_.resize(count);
    trial_.resize(count);
    const auto evaluate = [this](const std::vector<Vec3>& velocities) { return potential_.evaluate(velocities); };
    current_ = evaluate(velocities_);
    const double first = current_.residual;
    StepReport report;
    if (first <= current_.rounding) {
      return report;  // the residual at the start is rounding only
    }
    while (current_.residual > parameters.iteration.tolerance * first &&
           report.iterations < parameters.iteration.maxIterations) {
      checkStop(inputs);
      if (!findDirection(parameters.derivative) ||
          !searchLine(evaluate, direction_, slope_, velocities_, current_, trial_)) {
        break;  // rounding prevents further decrease
      }
      ++report.iterations;
    }
    report.residual = current_.residual / first;
    report.converged = current_.residual <= std::max(parameters.iteration.tolerance * first, current_.rounding);
    return report;
  }

  /// Newton's direction. Only the exact variant of the Hessian may be indefinite; the stabilised one then replaces it.
  bool findDirection(ForceDerivative variant) {
    if (!factorise(variant) && (variant != ForceDerivative::Exact || !factorise(ForceDerivative::Stabilised))) {
      return false;
    }
    const Eigen::VectorXd gradient = factorisation_->hessian.gather(potential_.gradient());
    const Eigen::VectorXd direction = factorisation_->cholesky.solve(-gradient);
    slope_ = gradient.dot(direction);
    factorisation_->hessian.scatter(direction, direction_);
    return true;
  }

  bool factorise(ForceDerivative variant) {
    potential_.fillHessian(variant, factorisation_->hessian);
    factorisation_->cholesky.factorize(factorisation_->hessian.lower());
    return factorisation_->cholesky.info() == Eigen::Success;
  }

  Workers workers_;
  ModelCache<std::unique_ptr<Factorisation>> cache_;
  Factorisation* factorisation_ = nullptr;  // of the step's model
  IncrementalPotential potential_;
  PotentialValue current_;
  double slope_ = 0.0;            // of the potential along the direction [J]
  std::vector<Vec3> velocities_;  // [m/s]
  std::vector<Vec3> direction_;   // [m/s]
  std::vector<Vec3> trial_;       // [m/s]
};

/// The warning is given if a step takes tens of milliseconds or more.
std::optional<SolverWarning> newtonWarning(const ClothModel& model, const StepParameters& /*parameters*/) {
  constexpr int maxInteractive = 1000;  // vertices
  if (model.vertexCount() <= maxInteractive) {
    return std::nullopt;
  }
  return SolverWarning{.kind = SolverWarning::Kind::TooSlow};
}

}  // namespace

SolverInfo solvers::newton() {
  return {
      .name = "newton",
      .title = "Newton (implicit)",
      .help =
          "Fully converged backward Euler: Newton's method with a sparse Cholesky factorisation in each iteration "
          "solves the nonlinear equations of the step to the tolerance. It is the reference for all backward-Euler "
          "methods. With one iteration it is the exact solve of the linearised step. Slow; the cost grows faster than "
          "the mesh. Other derivatives than the exact one give the same result after more iterations.",
      .source = "Gast and co-authors (2015), Optimization integrator for large time steps",
      .backwardEuler = true,
      .takesFabric = true,
      .settings = {"tolerance", "max_iterations", "derivative"},
      .warning = newtonWarning,
      .make = []() -> std::unique_ptr<Solver> { return std::make_unique<NewtonSolver>(); }};
}

}  // namespace drape::sim
