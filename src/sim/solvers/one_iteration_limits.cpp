#include "sim/solvers/one_iteration_limits.hpp"

#include "sim/stability.hpp"

#include <cmath>
#include <sstream>

namespace drape::solvers {
namespace {

constexpr double maxGainNumber = 1e4;           // of energyGainNumber
constexpr double maxWithIndefiniteMatrix = 25;  // of (h omega)^2 a sweep, with a derivative that is not stabilised
constexpr double maxSubstepSetting = 1000;      // the largest number in the settings (settings_table.cpp)

double substepOf(const StepParameters& parameters) {
  return parameters.timeStep / parameters.substeps;
}

/// (h omega)^2 of a substep over the number of sweeps times the relaxation.
double stiffnessNumber(const ClothModel& model, const StepParameters& parameters) {
  const double sweeps = parameters.relaxation * parameters.sweeps;
  return std::pow(substepOf(parameters) * largestFrequency(model, parameters), 2) / sweeps;
}

bool isUnstableIfStiff(ForceDerivative derivative) {
  return derivative != ForceDerivative::Stabilised && derivative != ForceDerivative::Scalar;
}

/// "Use 12 substeps or ...": `factor` times the present number of substeps, or `otherwise`.
std::string remedy(const StepParameters& parameters, double factor, const char* otherwise) {
  const double needed = std::ceil(factor * parameters.substeps * (1.0 - 1e-12));
  std::ostringstream words;
  if (needed <= maxSubstepSetting) {
    words << "Use " << needed << " substeps or " << otherwise << '.';
  } else {
    words << "Use " << otherwise << '.';
  }
  return words.str();
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

std::string oneIterationWarning(const ClothModel& model, const StepParameters& parameters) {
  const double stiff = stiffnessNumber(model, parameters);
  if (isUnstableIfStiff(parameters.derivative) && stiff > maxWithIndefiniteMatrix) {
    return "With this force derivative stiff cloth can blow up at this time step. " +
           remedy(parameters, std::sqrt(stiff / maxWithIndefiniteMatrix), "the stabilised derivative");
  }
  if (stiff <= 1.0) {
    return {};
  }
  const double gain = energyGainNumber(model, parameters);
  if (gain > maxGainNumber) {
    return "The time step is too long for this fine and stiff mesh: flat cloth gains energy and can blow up. " +
           remedy(parameters, std::pow(gain / maxGainNumber, 0.25), "a solver that solves for all springs at once");
  }
  std::ostringstream words;
  words << (parameters.sweeps == 1 ? std::string("One sweep is") : std::to_string(parameters.sweeps) + " sweeps are")
        << " too few at this stiffness and time step: the cloth is slack and loses momentum. "
        << remedy(parameters, std::sqrt(stiff), "more sweeps");
  return words.str();
}

}  // namespace drape::solvers
