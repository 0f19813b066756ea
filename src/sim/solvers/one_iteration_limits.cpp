#include "sim/solvers/one_iteration_limits.hpp"

#include "sim/stability.hpp"

#include <cmath>
#include <sstream>

namespace drape::solvers {
namespace {

constexpr double calmGain = 1e4;       // of energyGainNumber
constexpr double calmIndefinite = 25;  // of (h omega)^2 a sweep, with a derivative that is not stabilised
constexpr double mostSubsteps = 1000;  // more cannot be set (settings_table.cpp)

double substepOf(const StepParameters& parameters) {
  return parameters.timeStep / parameters.substeps;
}

/// (h omega)^2 of a substep over what the sweeps carry: one each, less where they are damped.
double stiffnessNumber(const ClothModel& model, const StepParameters& parameters) {
  const double reach = parameters.relaxation * parameters.sweeps;
  return std::pow(substepOf(parameters) * largestFrequency(model, parameters), 2) / reach;
}

bool blowsUpByItsDerivative(ForceDerivative derivative) {
  return derivative != ForceDerivative::Stabilised && derivative != ForceDerivative::Scalar;
}

/// "Use 12 substeps", of which `factor` times as many as now are needed.
std::string cure(const StepParameters& parameters, double factor, const char* otherwise) {
  const double needed = std::ceil(factor * parameters.substeps * (1.0 - 1e-12));
  std::ostringstream words;
  if (needed <= mostSubsteps) {
    words << "Use " << needed << " substeps or " << otherwise << '.';
  } else {
    words << "Use " << otherwise << '.';
  }
  return words.str();
}

}  // namespace

double energyGainNumber(const ClothModel& model, const StepParameters& parameters) {
  if (parameters.derivative == ForceDerivative::Scalar) {
    return 0.0;  // never seen to gain any
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
  if (blowsUpByItsDerivative(parameters.derivative) && stiff > calmIndefinite) {
    return "With this force derivative stiff cloth can blow up at such a time step. " +
           cure(parameters, std::sqrt(stiff / calmIndefinite), "the stabilised derivative");
  }
  if (stiff <= 1.0) {
    return {};
  }
  const double gain = energyGainNumber(model, parameters);
  if (gain > calmGain) {
    return "The time step is too long for so fine and stiff a mesh: flat cloth gains energy and can blow up. " +
           cure(parameters, std::pow(gain / calmGain, 0.25), "a solver that solves for all springs at once");
  }
  std::ostringstream words;
  words << (parameters.sweeps == 1 ? std::string("One sweep is") : std::to_string(parameters.sweeps) + " sweeps are")
        << " too few at this stiffness and time step: the cloth is slack and loses momentum. "
        << cure(parameters, std::sqrt(stiff), "more sweeps");
  return words.str();
}

}  // namespace drape::solvers
