#include "sim/simd/sliced_run.hpp"
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

bool startsFromZero(int iterations) {
  return iterations % 2 == 0;
}

/// Block Jacobi on the system of the one-iteration method, with Chebyshev's semi-iteration on top (Wang 2015). With
/// B(x) one block-Jacobi sweep and rho what is taken for the iteration's spectral radius,
///
///     x_(k+1) = omega_(k+1) (B(x_k) - x_(k-1)) + x_(k-1)
///     omega_1 = 1,  omega_2 = 2 / (2 - rho^2),  omega_(k+1) = 4 / (4 - rho^2 omega_k)
///
/// An odd number of iterations starts from p_i = h W_ii^-1 f~_i as one_iteration does, so that one iteration is the
/// same step in both; an even number starts from zero. The error of a mode of the Jacobi eigenvalue mu is then
/// multiplied by an even polynomial of mu either way. An odd one nears -1 where mu does, which doubles the answer:
/// stiff cloth would rattle, as it does with an even number of plain sweeps.
class ChebyshevSolver final : public Solver {
 public:
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) override {
    return steps(model, parameters, inputs, 1, state);
  }

  /// The sweeps are those of the one-iteration method with weights. From zero the first one's answer is p, which is
  /// where those sweeps start: an even number of iterations takes one sweep fewer, and leaves the first weight out.
  StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                   ClothState& state) override {
    StepParameters sweeping = parameters;
    const int skipped = startsFromZero(parameters.iterations) ? 1 : 0;
    sweeping.sweeps = parameters.iterations - skipped;
    sweeping.relaxation = 1.0;
    Weights weights(parameters.spectralRadius);
    std::vector<double> ofSweeps;
    for (int iteration = 0; iteration < parameters.iterations; ++iteration) {
      const double weight = weights.next();
      if (iteration >= skipped) {
        ofSweeps.push_back(weight);
      }
    }
    run_.oneIteration(model, sweeping, inputs, count, ofSweeps, state);
    return {.iterations = count * parameters.iterations};
  }

 private:
  SlicedRun run_;
};

/// What is left of the error of a mode of the Jacobi eigenvalue mu, with its sign: the solver's recursion on one
/// number.
double errorLeft(const StepParameters& parameters, double mu) {
  double current = startsFromZero(parameters.iterations) ? 1.0 : mu;
  double previous = current;
  Weights weights(parameters.spectralRadius);
  for (int iteration = 0; iteration < parameters.iterations; ++iteration) {
    previous = weights.next() * (mu * current - previous) + previous;
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
  for (int i = 0; i <= samples; ++i) {
    const double mu = radius * (2.0 * i / samples - 1.0);
    if (errorLeft(parameters, mu) < -mostOvershoot) {
      return "The iterations overshoot at this stiffness and time step: the cloth may rattle. Take more iterations or "
             "a "
             "smaller spectral radius.";
    }
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
