#include "sim/incremental_potential.hpp"
#include "sim/model_cache.hpp"
#include "sim/solvers/registry.hpp"
#include "sim/sparse_system.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <memory>

namespace drape {
namespace {

/// A share of the slope's promise that a step must keep (Armijo's condition).
constexpr double sufficientDecrease = 1e-4;
/// Steps shorter than 2^-30 of Newton's change nothing any more.
constexpr int mostHalvings = 30;

/// The Cholesky factorisation of a cloth's Hessian; the ordering and the pattern of the factor belong to the model.
struct Factorisation {
  explicit Factorisation(const ClothModel& model) : hessian(model) {
    if (hessian.lower().rows() > 0) {
      cholesky.analyzePattern(hessian.lower());
    }
  }
  SparseSystem hessian;
  Eigen::SimplicialLLT<SparseSystem::Matrix, Eigen::Lower> cholesky;
};

/// Backward Euler solved to the end: Newton's method with a line search on the incremental potential (Gast et al. 2015
/// for the potential; Nocedal and Wright, Numerical Optimization, algorithms 3.1 and 3.2).
///
/// It starts from zero velocities, where the ends of the step are still the positions of its start. The first iterate
/// is therefore the linearised step of Baraff and Witkin (1998), W dv = h f~, wherever the line search takes it whole.
///
/// A step has converged when its residual is below the tolerance, relative to that of zero velocities, or where
/// rounding lets it get no smaller.
class NewtonSolver final : public Solver {
 public:
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) override {
    factorisation_ = cache_.get(model, [](const ClothModel& m) { return std::make_unique<Factorisation>(m); }).get();
    potential_.begin(model, parameters, inputs, state, workers_);
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
    current_ = potential_.evaluate(velocities_);
    const double first = current_.residual;
    StepReport report;
    if (first <= current_.rounding) {
      return report;  // nothing but rounding is left over where it starts
    }
    while (current_.residual > parameters.tolerance * first && report.iterations < parameters.maxIterations) {
      checkStop(inputs);
      if (!findDirection(parameters.derivative) || !searchAlongIt()) {
        break;  // rounding is in the way of more
      }
      ++report.iterations;
    }
    report.residual = current_.residual / first;
    report.converged = current_.residual <= std::max(parameters.tolerance * first, current_.rounding);
    return report;
  }

  /// Newton's direction. Where the Hessian is not positive definite, which of the variants only the exact one need not
  /// be, the stabilised one stands in.
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

  /// Goes the largest share 1, 1/2, 1/4 ... of the direction that lowers the potential enough. Where the potential
  /// changes by no more than its rounding, the residual decides. Returns false when no share does.
  bool searchAlongIt() {
    double share = 1.0;
    for (int halving = 0; halving <= mostHalvings; ++halving, share *= 0.5) {
      for (std::size_t i = 0; i < velocities_.size(); ++i) {
        trial_[i] = velocities_[i] + share * direction_[i];
      }
      const IncrementalPotential::Value value = potential_.evaluate(trial_);
      const double change = value.value - current_.value;
      const bool lower = change <= sufficientDecrease * share * slope_ && change < -current_.valueRounding;
      const bool level = std::abs(change) <= current_.valueRounding && value.residual < current_.residual;
      if (lower || level) {
        current_ = value;
        velocities_.swap(trial_);
        return true;
      }
    }
    current_ = potential_.evaluate(velocities_);
    return false;
  }

  Workers workers_;
  ModelCache<std::unique_ptr<Factorisation>> cache_;
  Factorisation* factorisation_ = nullptr;  // of the step's model
  IncrementalPotential potential_;
  IncrementalPotential::Value current_;
  double slope_ = 0.0;            // of the potential along the direction [J]
  std::vector<Vec3> velocities_;  // [m/s]
  std::vector<Vec3> direction_;   // [m/s]
  std::vector<Vec3> trial_;       // [m/s]
};

/// A step of 17 x 17 vertices takes milliseconds, of 33 x 33 tens and of 61 x 61 hundreds.
std::string newtonWarning(const ClothModel& model, const StepParameters& /*parameters*/) {
  constexpr int fluent = 1000;  // vertices
  if (model.vertexCount() <= fluent) {
    return {};
  }
  return "Newton's method factorises a large matrix several times a step: on a mesh this fine it is for measuring, not "
         "for "
         "watching.";
}

}  // namespace

SolverInfo solvers::newton() {
  return {
      .name = "newton",
      .title = "Newton (implicit)",
      .help =
          "Backward Euler with nothing left out: the step's nonlinear equations solved to the tolerance by Newton's "
          "method with a sparse Cholesky factorisation in each iteration. What every backward-Euler method would "
          "give if it went on to the end, and so the one to measure them against; with one iteration it is the exact "
          "solve of the linearised step. Slow, and slower than in proportion on fine meshes; a derivative other than "
          "the exact one ends in the same place after more iterations.",
      .source = "Gast and co-authors (2015), Optimization integrator for large time steps",
      .backwardEuler = true,
      .settings = {"tolerance", "max_iterations", "derivative"},
      .warning = newtonWarning,
      .make = []() -> std::unique_ptr<Solver> { return std::make_unique<NewtonSolver>(); }};
}

}  // namespace drape
