#include "sim/simd/sliced_run.hpp"
#include "sim/solvers/batch_solver.hpp"
#include "sim/solvers/registry.hpp"
#include "sim/stability.hpp"

#include <utility>

namespace drape {
namespace {

/// The weights omega_1, omega_2 ... of the iterations.
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

/// The weights of the sweeps that follow on p, see ChebyshevSolver.
std::vector<double> weightsOfSweeps(const StepParameters& parameters) {
  const bool even = parameters.iterations % 2 == 0;
  std::vector<double> weights(even ? 1U : 0U, 1.0);
  Weights next(parameters.spectralRadius);
  for (int iteration = even ? 2 : 0; iteration < parameters.iterations; ++iteration) {
    weights.push_back(next.next());
  }
  return weights;
}

/// Block Jacobi on the system of the one-iteration method, with Chebyshev's semi-iteration on top (Wang 2015). With
/// B(x) one block-Jacobi sweep and rho what is taken for the iteration's spectral radius,
///
///     x_(k+1) = omega_(k+1) (B(x_k) - x_(k-1)) + x_(k-1)
///     omega_1 = 1,  omega_2 = 2 / (2 - rho^2),  omega_(k+1) = 4 / (4 - rho^2 omega_k)
///
/// The start is p_i = h W_ii^-1 f~_i as in one_iteration, whose error in a mode of the Jacobi eigenvalue mu is mu, and
/// an odd number n of iterations multiplies it by T_n: an even polynomial of mu. An even number would make it an odd
/// one, which nears -1 where mu does and doubles the answer: stiff cloth would rattle, as it does with an even number
/// of plain sweeps. So for an even n the start counts as the first iteration, then comes one plain sweep, then n - 2
/// weighted ones: mu^2 T_(n-2). Both vanish at mu = 0, so that nothing is left of the error as the step goes to zero.
class ChebyshevSolver final : public BatchSolver {
 public:
  /// The sweeps are those of the one-iteration method with weights. A plain sweep is one whose weight is 1.
  StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                   ClothState& state) override {
    const std::vector<double> ofSweeps = weightsOfSweeps(parameters);
    StepParameters sweeping = parameters;
    sweeping.sweeps = static_cast<int>(ofSweeps.size());
    sweeping.relaxation = 1.0;
    run_.oneIteration(model, sweeping, inputs, count, ofSweeps, state);
    return {.iterations = count * parameters.iterations};
  }

 private:
  SlicedRun run_;
};

/// What is left of the error of a mode of the Jacobi eigenvalue mu, with its sign: the solver's recursion on one
/// number.
double errorLeft(const std::vector<double>& weights, double mu) {
  double current = mu;
  double previous = 0.0;
  for (const double weight : weights) {
    previous = weight * (mu * current - previous) + previous;
    std::swap(current, previous);
  }
  return current;
}

/// A backward-Euler oscillator whose velocity change is g times the exact one rattles when g > 4/3 and the oscillator
/// is stiff; an error of the opposite sign makes g that large.
std::string warningOf(const ClothModel& model, const StepParameters& parameters) {
  constexpr double mostOvershoot = 1.0 / 3.0;
  constexpr int samples = 64;
  const double h = parameters.timeStep / parameters.substeps;
  const double omega = largestFrequency(model, parameters);
  const double stiff = 0.5 * h * (h * omega * omega + model.unitDampingRate * parameters.damping);
  const double radius = stiff / (1.0 + stiff);  // a bound for |mu|
  const std::vector<double> weights = weightsOfSweeps(parameters);
  for (int i = 0; i <= samples; ++i) {
    const double mu = radius * (2.0 * i / samples - 1.0);
    if (errorLeft(weights, mu) < -mostOvershoot) {
      return "The iterations overshoot at this stiffness and time step: the cloth may rattle. Take more iterations or "
             "a smaller spectral radius.";
    }
  }
  // As much as plain sweeps leave where one_iteration calls itself slack.
  constexpr double mostLeft = 0.12;
  if (errorLeft(weights, radius) > mostLeft) {
    return "Too few iterations for this stiffness and time step: the cloth is slack. Take more iterations, a larger "
           "spectral radius, or substeps.";
  }
  return {};
}

}  // namespace

SolverInfo solvers::chebyshev() {
  return {
      .name = "chebyshev",
      .title = "Chebyshev (implicit)",
      .help =
          "Backward Euler whose linear system is solved by block Jacobi with Chebyshev acceleration: the sweeps of "
          "one_iteration, each weighted against the one before last. An iteration costs what a sweep costs and "
          "brings stiff cloth further. Takes a fixed number of iterations whatever is left of the error; too large a "
          "spectral radius overshoots, and stiff cloth then rattles.",
      .source =
          "Wang (2015), A Chebyshev semi-iterative approach for accelerating projective and position-based "
          "dynamics",
      .backwardEuler = true,
      .settings = {"iterations", "spectral_radius", "derivative", "precision"},
      .warning = warningOf,
      .make = []() -> std::unique_ptr<Solver> { return std::make_unique<ChebyshevSolver>(); }};
}

}  // namespace drape
