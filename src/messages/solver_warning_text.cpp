#include "messages/solver_warning_text.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

namespace drape::messages {
namespace {

using text::plural;
using text::Sentence;

/// "12 substeps", or nothing where the settings do not allow as many.
Sentence substepsUpToTheMaximum(double substeps) {
  constexpr double maxSubsteps = 1000.0;  // the largest number in the settings (settings_table.cpp)
  return substeps <= maxSubsteps ? Sentence("{} substeps", fmt::format("{:g}", substeps)) : Sentence();
}

/// The problem, then "Use 12 substeps or more sweeps."
Sentence withRemedy(Sentence problem, double substeps, const Sentence& otherwise) {
  const Sentence count = substepsUpToTheMaximum(substeps);
  return problem.append(" ",
                        count.empty() ? Sentence("Use {}.", otherwise) : Sentence("Use {} or {}.", count, otherwise));
}

/// Two significant digits.
std::string inTwoDigits(double value) {
  return fmt::format("{:.2g}", value);
}

Sentence stepTooLong(const sim::SolverWarning& warning) {
  const Sentence substeps = substepsUpToTheMaximum(warning.substeps);
  Sentence words("The time step is above this mesh's stability limit of {}: the cloth can blow up.",
                 stepInWords(warning.seconds));
  return words.append(
      " ",
      Sentence("Use {}.", substeps.empty() ? Sentence("softer or heavier cloth or an implicit solver") : substeps));
}

Sentence tooFewIterations(const sim::SolverWarning& warning) {
  const bool reachable = !substepsUpToTheMaximum(warning.substeps).empty();
  return withRemedy(
      Sentence(plural(warning.iterations,
                      "{} iteration is too few for this stiffness and time step: the cloth is softer than specified, "
                      "and it can gain energy.",
                      "{} iterations are too few for this stiffness and time step: the cloth is softer than specified, "
                      "and it can gain energy."),
               warning.iterations),
      warning.substeps,
      reachable ? Sentence("more iterations")
                : Sentence("more iterations, or a solver that solves for all springs at once"));
}

Sentence tooFewSweeps(const sim::SolverWarning& warning) {
  return withRemedy(
      Sentence(plural(warning.iterations,
                      "One sweep is too few at this stiffness and time step: the cloth is slack and loses momentum.",
                      "{} sweeps are too few at this stiffness and time step: the cloth is slack and loses momentum."),
               warning.iterations),
      warning.substeps, Sentence("more sweeps"));
}

Sentence wrongSpectralRadius(const sim::SolverWarning& warning) {
  return Sentence(
      "With {} iterations a spectral radius of {} overshoots: the cloth can blow up. Use {} iterations or a smaller "
      "spectral radius.",
      warning.iterations, fmt::format("{:g}", warning.spectralRadius), warning.neededIterations);
}

Sentence softened(const sim::SolverWarning& warning) {
  return Sentence(
      "{}: the springs keep {} % of their stiffness, and coarse levels carry the tension. The full stiffness needs "
      "auto.cost = {}.",
      warning.softenedByChoice ? Sentence("The cost budget is too small for this stiff and fine cloth")
                               : Sentence("At full stiffness a step of this cloth would take several seconds"),
      inTwoDigits(100.0 * warning.stiffnessScale), fmt::format("{:.0f}", warning.neededCost));
}

Sentence indefiniteMatrix(const sim::SolverWarning& warning) {
  return withRemedy(Sentence("With this force derivative stiff cloth can blow up at this time step."), warning.substeps,
                    Sentence("the stabilised derivative"));
}

Sentence flatClothGains(const sim::SolverWarning& warning) {
  return withRemedy(
      Sentence("The time step is too long for this fine and stiff mesh: flat cloth gains energy and can blow up."),
      warning.substeps, Sentence("a solver that solves for all springs at once"));
}

Sentence stiffFolds(const sim::SolverWarning& warning) {
  return withRemedy(Sentence("At this stiffness and time step folding meets as much resistance as stretching: the "
                             "cloth moves far too slowly."),
                    warning.substeps, Sentence("softer cloth"));
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

text::Sentence inWords(const sim::SolverWarning& warning) {
  using Kind = sim::SolverWarning::Kind;
  switch (warning.kind) {
    case Kind::StepTooLong:
      return stepTooLong(warning);
    case Kind::GainsEnergy:
      return Sentence(
          "Explicit Euler gains energy at any time step. At this one the energy of the fastest motion doubles every {} "
          "s. Use much shorter steps, add damping or choose another solver.",
          inTwoDigits(warning.seconds));
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
      return Sentence(
          "Too few iterations for this stiffness and time step: the cloth is slack. Use more iterations, a larger "
          "spectral radius or substeps.");
    case Kind::Overshoots:
      return Sentence(
          "The iterations overshoot at this stiffness and time step: the cloth may oscillate. Use more iterations or a "
          "smaller spectral radius.");
    case Kind::SpectralRadius:
      return wrongSpectralRadius(warning);
    case Kind::InexactInFloat:
      return Sentence(
          "Substeps below {} are too short for XPBD in float: velocities become inexact. Use double precision.",
          stepInWords(warning.seconds));
    case Kind::TooSlow:
      return Sentence(
          "Newton's method factorises a large matrix several times in each step: on so fine a mesh it is too slow for "
          "interactive use.");
    case Kind::Softened:
      return softened(warning);
    case Kind::SlowMotion:
      return Sentence(
          "This stiff and fine cloth costs up to {} times the cost budget, so it moves in slow motion. Softer springs "
          "keep real time (auto.soften = on).",
          inTwoDigits(warning.costRatio));
    case Kind::SlowFabric:
      return Sentence(
          "This stiff and fine fabric costs up to {} times the cost budget, so it moves in slow motion. A lower "
          "stretch "
          "stiffness keeps real time where the strain stays small (auto.strain = 0.01).",
          inTwoDigits(warning.costRatio));
    case Kind::LimitedLift:
      return Sentence(
          "The paper's lift jumps where cloth lies along the wind. The solver auto limits it there to the lift of a "
          "thin plate, and other solvers do not. The air model of a thin plate has no jump (air.model = plate).");
  }
  return {};
}

}  // namespace drape::messages
