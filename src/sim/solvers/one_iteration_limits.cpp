#include "sim/solvers/one_iteration_limits.hpp"

#include "sim/forces/stability.hpp"

#include <cmath>

namespace drape::sim::solvers {
namespace {

constexpr double maxGainNumber = 1e4;           // of energyGainNumber
constexpr double maxWithIndefiniteMatrix = 25;  // of (h omega)^2 a sweep, with a derivative that is not stabilised

double substepOf(const StepParameters& parameters) {
  return parameters.timeStep / parameters.substeps;
}

/// (h omega)^2 of a substep over the number of sweeps times the relaxation.
double stiffnessNumber(const ClothModel& model, const StepParameters& parameters) {
  const double sweeps = parameters.jacobi.relaxation * parameters.jacobi.sweeps;
  return std::pow(substepOf(parameters) * largestFrequency(model, parameters), 2) / sweeps;
}

bool isUnstableIfStiff(ForceDerivative derivative) {
  return derivative != ForceDerivative::Stabilised && derivative != ForceDerivative::Scalar;
}

/// A warning that `factor` times the present number of substeps avoids.
SolverWarning avoidedBy(const StepParameters& parameters, SolverWarning::Kind kind, double factor) {
  constexpr double rounding = 1e-12;
  return {.kind = kind, .substeps = std::ceil(factor * parameters.substeps * (1.0 - rounding))};
}

}  // namespace

double energyGainNumber(const ClothModel& model, const StepParameters& parameters) {
  if (parameters.derivative == ForceDerivative::Scalar) {
    return 0.0;  // no energy gain was observed
  }
  const double h = substepOf(parameters);
  const double size = std::sqrt(model.restArea());
  if (!(size > 0.0)) {
    return 0.0;
  }
  return stiffnessNumber(model, parameters) * h * h * model.vertexCount() * parameters.gravity / size;
}

std::optional<SolverWarning> oneIterationWarning(const ClothModel& model, const StepParameters& parameters) {
  using Kind = SolverWarning::Kind;
  const double stiff = stiffnessNumber(model, parameters);
  if (isUnstableIfStiff(parameters.derivative) && stiff > maxWithIndefiniteMatrix) {
    return avoidedBy(parameters, Kind::IndefiniteMatrix, std::sqrt(stiff / maxWithIndefiniteMatrix));
  }
  if (stiff <= 1.0) {
    return std::nullopt;
  }
  const double gain = energyGainNumber(model, parameters);
  if (gain > maxGainNumber) {
    return avoidedBy(parameters, Kind::FlatClothGains, std::pow(gain / maxGainNumber, 0.25));
  }
  SolverWarning slack = avoidedBy(parameters, Kind::TooFewSweeps, std::sqrt(stiff));
  slack.iterations = parameters.jacobi.sweeps;
  return slack;
}

}  // namespace drape::sim::solvers
