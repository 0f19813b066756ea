#include "sim/stability.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace drape {
namespace {

/// The largest number of substeps in the settings (settings_table.cpp).
constexpr double maxSubsteps = 1000.0;

}  // namespace

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

std::string stepInWords(double seconds) {
  std::ostringstream words;
  if (!(seconds < 1.0)) {
    words << seconds << " s";
    return words.str();
  }
  const double denominator = 1.0 / seconds;
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(denominator)) - 2.0));
  words << std::fixed << std::setprecision(0) << "1/" << std::ceil(denominator / unit * (1.0 - 1e-12)) * unit << " s";
  return words.str();
}

std::string stepLimitWarning(const StepParameters& parameters, double limit) {
  if (parameters.timeStep / parameters.substeps <= limit) {
    return {};
  }
  std::ostringstream words;
  words << "The time step is above this mesh's stability limit of " << stepInWords(limit) << ": the cloth "
        << "can blow up. ";
  const double needed = std::ceil(parameters.timeStep / limit * (1.0 - 1e-12));
  if (needed <= maxSubsteps) {
    words << "Use " << needed << " substeps.";
  } else {
    words << "Use softer or heavier cloth or an implicit solver.";
  }
  return words.str();
}

std::string stiffFoldsWarning(const ClothModel& model, const StepParameters& parameters) {
  constexpr double limit = 0.1;  // of (h omega)^2
  const double needed = parameters.timeStep * largestFrequency(model, parameters) / std::sqrt(limit);
  if (needed <= parameters.substeps) {
    return {};
  }
  std::ostringstream words;
  words << "At this stiffness and time step folding meets as much resistance as stretching: the cloth moves far too "
           "slowly. Use ";
  if (needed <= maxSubsteps) {
    words << std::ceil(needed) << " substeps or ";
  }
  words << "softer cloth.";
  return words.str();
}

std::string slackWarning(const ClothModel& model, const StepParameters& parameters, double perIteration) {
  const double maxHOmega = std::sqrt(perIteration * parameters.iterations);
  const double needed = parameters.timeStep * largestFrequency(model, parameters) / maxHOmega;
  if (needed <= parameters.substeps) {
    return {};
  }
  std::ostringstream words;
  words << parameters.iterations << (parameters.iterations == 1 ? " iteration is" : " iterations are")
        << " too few for this stiffness and time step: the cloth is softer than specified. ";
  if (needed <= maxSubsteps) {
    words << "Use " << std::ceil(needed) << " substeps or more iterations.";
  } else {
    words << "Use more iterations, or a solver that solves for all springs at once.";
  }
  return words.str();
}

}  // namespace drape
