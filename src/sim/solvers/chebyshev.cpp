#include "sim/forces/stability.hpp"
#include "sim/simd/sliced_run.hpp"
#include "sim/solvers/assembled_run.hpp"
#include "sim/solvers/batch_solver.hpp"
#include "sim/solvers/registry.hpp"

#include <utility>

namespace drape::sim {
namespace {

/// The weights omega_1, omega_2, ... of the iterations.
class Weights {
 public:
  explicit Weights(double spectralRadius) : square_(spectralRadius * spectralRadius) {}

  double next() {
    weight_ = count_ == 0 ? 1.0 : (count_ == 1 ? 2.0 / (2.0 - square_) : 4.0 / (4.0 - square_ * weight_));
    ++count_;
    return weight_;
  }

 private:
  double square_;
  double weight_ = 1.0;
  int count_ = 0;
};

/// The weights of the sweeps after the start p, see ChebyshevSolver.
std::vector<double> weightsOfSweeps(const StepParameters& parameters) {
  const bool even = parameters.iteration.iterations % 2 == 0;
  std::vector<double> weights(even ? 1U : 0U, 1.0);
  Weights next(parameters.iteration.spectralRadius);
  for (int iteration = even ? 2 : 0; iteration < parameters.iteration.iterations; ++iteration) {
    weights.push_back(next.next());
  }
  return weights;
}

/// Block Jacobi on the system of the one-iteration method, accelerated by Chebyshev's semi-iteration (Wang 2015). With
/// B(x) one block-Jacobi sweep and rho the assumed spectral radius of the iteration,
///
///     x_(k+1) = omega_(k+1) (B(x_k) - x_(k-1)) + x_(k-1)
///     omega_1 = 1,  omega_2 = 2 / (2 - rho^2),  omega_(k+1) = 4 / (4 - rho^2 omega_k)
///
/// The start is p_i = h W_ii^-1 f~_i as in one_iteration. Its relative error in a mode of the Jacobi eigenvalue mu is
/// mu, and n iterations multiply it by Chebyshev's polynomial T_n of mu / rho, divided by T_n(1 / rho). For odd n the
/// product is an even polynomial of mu. For even n it would be odd: it would approach -1 as mu does, which doubles the
/// velocity change, and stiff cloth would oscillate, as with an even number of plain sweeps. So for even n the start
/// counts as the first iteration, followed by one plain sweep and n - 2 weighted ones, with the error mu^2 T_(n-2).
/// Both polynomials vanish at mu = 0, so the error vanishes as the step goes to zero.
class ChebyshevSolver final : public BatchSolver {
 public:
  /// The sweeps are those of the one-iteration method with weights. A plain sweep has weight 1.
  StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                   ClothState& state) override {
    const std::vector<double> ofSweeps = weightsOfSweeps(parameters);
    const simd::JacobiOptions sweeping{.sweeps = static_cast<int>(ofSweeps.size()), .relaxation = 1.0};
    if (model.fabric) {
      assembled_.oneIteration(model, parameters, sweeping, inputs, count, ofSweeps, state);
    } else {
      run_.oneIteration(model, parameters, sweeping, inputs, count, ofSweeps, state);
    }
    return {.iterations = count * parameters.iteration.iterations};
  }

 private:
  simd::SlicedRun run_;
  AssembledRun assembled_;  // of fabrics
};

/// The remaining error of a mode with Jacobi eigenvalue mu, signed: the solver's recursion for one number.
double remainingError(const std::vector<double>& weights, double mu) {
  double current = mu;
  double previous = 0.0;
  for (const double weight : weights) {
    previous = weight * (mu * current - previous) + previous;
    std::swap(current, previous);
  }
  return current;
}

/// A stiff backward-Euler oscillator is unstable if its velocity change is g > 4/3 times the exact one. A remaining
/// error below -1/3 means that.
std::optional<SolverWarning> warningOf(const ClothModel& model, const StepParameters& parameters) {
  constexpr double maxOvershoot = 1.0 / 3.0;
  constexpr int samples = 64;
  const double h = parameters.timeStep / parameters.substeps;
  const double omega = largestFrequency(model, parameters);
  const double stiff = 0.5 * h * (h * omega * omega + model.unitDampingRate * parameters.material.damping);
  const double radius = stiff / (1.0 + stiff);  // a bound for |mu|
  const std::vector<double> weights = weightsOfSweeps(parameters);
  for (int i = 0; i <= samples; ++i) {
    const double mu = radius * (2.0 * i / samples - 1.0);
    if (remainingError(weights, mu) < -maxOvershoot) {
      return SolverWarning{.kind = SolverWarning::Kind::Overshoots};
    }
  }
  // The remaining error of plain sweeps where the warning of one_iteration begins.
  constexpr double maxError = 0.12;
  if (remainingError(weights, radius) > maxError) {
    return SolverWarning{.kind = SolverWarning::Kind::AcceleratedTooLittle};
  }
  return std::nullopt;
}

}  // namespace

SolverInfo solvers::chebyshev() {
  return {
      .name = "chebyshev",
      .title = "Chebyshev (implicit)",
      .help =
          "Backward Euler. Block Jacobi with Chebyshev acceleration solves the linear system: the sweeps of "
          "one_iteration with weights. An iteration costs as much as a sweep and converges faster for stiff cloth. The "
          "number of iterations is fixed. With too large a spectral radius the iterations overshoot, and stiff cloth "
          "oscillates.",
      .source =
          "Wang (2015), A Chebyshev semi-iterative approach for accelerating projective and position-based "
          "dynamics",
      .backwardEuler = true,
      .takesFabric = true,
      .settings = {"iterations", "spectral_radius", "derivative", "precision"},
      .warning = warningOf,
      .make = []() -> std::unique_ptr<Solver> { return std::make_unique<ChebyshevSolver>(); }};
}

}  // namespace drape::sim
