#include "sim/stability.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape {

double unitFrequencySquared(const ClothModel& model, std::size_t vertex) {
  Mat3 stiffness = Mat3::Zero();
  for (const SpringEnd& springEnd : model.springEnds[vertex]) {
    const Vec3 offset = model.restPositions[springEnd.neighbour] - model.restPositions[vertex];
    const double relative = model.springs[springEnd.spring].relativeStiffness;
    stiffness +=
        offset * offset.transpose() * (relative / std::max(offset.squaredNorm(), std::numeric_limits<double>::min()));
  }
  const double largest =
      Eigen::SelfAdjointEigenSolver<Mat3>().computeDirect(stiffness, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
  return 2.0 * largest / model.vertexMass[vertex];
}

double largestFrequency(const ClothModel& model, const StepParameters& parameters) {
  return model.unitFrequency * std::sqrt(parameters.stiffness);
}

double verletStepLimit(const ClothModel& model, const StepParameters& parameters) {
  const double omega = largestFrequency(model, parameters);
  const double c = model.unitDampingRate * parameters.damping;
  // The positive root of omega^2 h^2 + 2 c h - 4 = 0, in the form that does not cancel.
  const double denominator = c + std::sqrt(c * c + 4.0 * omega * omega);
  return denominator > 0.0 ? 4.0 / denominator : std::numeric_limits<double>::infinity();
}

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
  const double maxHOmega = std::sqrt(perIteration * parameters.iterations);
  const double needed = parameters.timeStep * largestFrequency(model, parameters) / maxHOmega;
  if (needed <= parameters.substeps) {
    return std::nullopt;
  }
  return SolverWarning{.kind = SolverWarning::Kind::TooFewIterations,
                       .substeps = std::ceil(needed),
                       .iterations = parameters.iterations};
}

}  // namespace drape
