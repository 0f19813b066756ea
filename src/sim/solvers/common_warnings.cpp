#include "sim/solvers/common_warnings.hpp"

#include "sim/forces/stability.hpp"

#include <cmath>

namespace drape::sim {

std::optional<SolverWarning> stepLimitWarning(const StepParameters& parameters, double limit) {
  if (parameters.timeStep / parameters.substeps <= limit) {
    return std::nullopt;
  }
  constexpr double rounding = 1e-12;
  return SolverWarning{.kind = SolverWarning::Kind::StepTooLong,
                       .substeps = std::ceil(parameters.timeStep / limit * (1.0 - rounding)),
                       .seconds = limit};
}

std::optional<SolverWarning> stiffFoldsWarning(const ClothModel& model, const StepParameters& parameters) {
  constexpr double limit = 0.1;  // of (h omega)^2
  const double needed = parameters.timeStep * largestFrequency(model, parameters) / std::sqrt(limit);
  if (needed <= parameters.substeps) {
    return std::nullopt;
  }
  return SolverWarning{.kind = SolverWarning::Kind::StiffFolds, .substeps = std::ceil(needed)};
}

std::optional<SolverWarning> slackWarning(const ClothModel& model, const StepParameters& parameters,
                                          double perIteration) {
  const double maxHOmega = std::sqrt(perIteration * parameters.iteration.iterations);
  const double needed = parameters.timeStep * largestFrequency(model, parameters) / maxHOmega;
  if (needed <= parameters.substeps) {
    return std::nullopt;
  }
  return SolverWarning{.kind = SolverWarning::Kind::TooFewIterations,
                       .substeps = std::ceil(needed),
                       .iterations = parameters.iteration.iterations};
}

}  // namespace drape::sim
