#include "messages/solver_warning_text.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

namespace drape::messages {
namespace {

/// "12 substeps", or nothing where the settings do not allow as many.
std::string substepsUpToTheMaximum(double substeps) {
  constexpr double maxSubsteps = 1000.0;  // the largest number in the settings (settings_table.cpp)
  return substeps <= maxSubsteps ? fmt::format("{:g} substeps", substeps) : std::string();
}

/// "Use 12 substeps or more sweeps."
std::string remedy(double substeps, const std::string& otherwise) {
  const std::string words = substepsUpToTheMaximum(substeps);
  return "Use " + (words.empty() ? words : words + " or ") + otherwise + '.';
}

/// Two significant digits.
std::string inTwoDigits(double value) {
  return fmt::format("{:.2g}", value);
}

std::string stepTooLong(const sim::SolverWarning& warning) {
  const std::string substeps = substepsUpToTheMaximum(warning.substeps);
  return "The time step is above this mesh's stability limit of " + stepInWords(warning.seconds) +
         ": the cloth can blow up. Use " +
         (substeps.empty() ? "softer or heavier cloth or an implicit solver" : substeps) + '.';
}

std::string tooFewIterations(const sim::SolverWarning& warning) {
  const bool reachable = !substepsUpToTheMaximum(warning.substeps).empty();
  return std::to_string(warning.iterations) + (warning.iterations == 1 ? " iteration is" : " iterations are") +
         " too few for this stiffness and time step: the cloth is softer than specified, and it can gain energy. " +
         remedy(warning.substeps,
                reachable ? "more iterations" : "more iterations, or a solver that solves for all springs at once");
}

std::string tooFewSweeps(const sim::SolverWarning& warning) {
  return (warning.iterations == 1 ? "One sweep is" : std::to_string(warning.iterations) + " sweeps are") +
         " too few at this stiffness and time step: the cloth is slack and loses momentum. " +
         remedy(warning.substeps, "more sweeps");
}

std::string wrongSpectralRadius(const sim::SolverWarning& warning) {
  return fmt::format(
      "With {} iterations a spectral radius of {:g} overshoots: the cloth can blow up. Use {} iterations or a smaller "
      "spectral radius.",
      warning.iterations, warning.spectralRadius, warning.neededIterations);
}

std::string softened(const sim::SolverWarning& warning) {
  return fmt::format(
      "{}: the springs keep {} % of their stiffness, and coarse levels carry the tension. The full stiffness needs "
      "auto.cost = {:.0f}.",
      warning.softenedByChoice ? "The cost budget is too small for this stiff and fine cloth"
                               : "At full stiffness a step of this cloth would take several seconds",
      inTwoDigits(100.0 * warning.stiffnessScale), warning.neededCost);
}

std::string indefiniteMatrix(const sim::SolverWarning& warning) {
  return "With this force derivative stiff cloth can blow up at this time step. " +
         remedy(warning.substeps, "the stabilised derivative");
}

std::string flatClothGains(const sim::SolverWarning& warning) {
  return "The time step is too long for this fine and stiff mesh: flat cloth gains energy and can blow up. " +
         remedy(warning.substeps, "a solver that solves for all springs at once");
}

std::string stiffFolds(const sim::SolverWarning& warning) {
  return "At this stiffness and time step folding meets as much resistance as stretching: the cloth moves far too "
         "slowly. " +
         remedy(warning.substeps, "softer cloth");
}

}  // namespace

std::string stepInWords(double seconds) {
  if (!(seconds < 1.0)) {
    return fmt::format("{:g} s", seconds);
  }
  const double denominator = 1.0 / seconds;
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(denominator)) - 2.0));
  return fmt::format("1/{:.0f} s", std::ceil(denominator / unit * (1.0 - 1e-12)) * unit);
}

std::string inWords(const sim::SolverWarning& warning) {
  using Kind = sim::SolverWarning::Kind;
  switch (warning.kind) {
    case Kind::StepTooLong:
      return stepTooLong(warning);
    case Kind::GainsEnergy:
      return "Explicit Euler gains energy at any time step. At this one the energy of the fastest motion doubles "
             "every " +
             inTwoDigits(warning.seconds) + " s. Use much shorter steps, add damping or choose another solver.";
    case Kind::IndefiniteMatrix:
      return indefiniteMatrix(warning);
    case Kind::FlatClothGains:
      return flatClothGains(warning);
    case Kind::TooFewSweeps:
      return tooFewSweeps(warning);
    case Kind::TooFewIterations:
      return tooFewIterations(warning);
    case Kind::StiffFolds:
      return stiffFolds(warning);
    case Kind::AcceleratedTooLittle:
      return "Too few iterations for this stiffness and time step: the cloth is slack. Use more iterations, a larger "
             "spectral radius or substeps.";
    case Kind::Overshoots:
      return "The iterations overshoot at this stiffness and time step: the cloth may oscillate. Use more iterations "
             "or a smaller spectral radius.";
    case Kind::SpectralRadius:
      return wrongSpectralRadius(warning);
    case Kind::InexactInFloat:
      return "Substeps below " + stepInWords(warning.seconds) +
             " are too short for XPBD in float: velocities become inexact. Use double precision.";
    case Kind::TooSlow:
      return "Newton's method factorises a large matrix several times in each step: on so fine a mesh it is too slow "
             "for interactive use.";
    case Kind::Softened:
      return softened(warning);
    case Kind::SlowMotion:
      return "This stiff and fine cloth costs up to " + inTwoDigits(warning.costRatio) +
             " times the cost budget, so it moves in slow motion. Softer springs keep real time (auto.soften = on).";
  }
  return {};
}

}  // namespace drape::messages
