#pragma once

#include "report/trajectory.hpp"

#include <string>
#include <vector>

namespace drape::report {

/// The kinds of reference. They answer different questions:
///
/// - the **same-step** reference solves the same step (time step, substeps, integration, derivative) to convergence by
///   Newton's method. The difference is the error of the method's approximation, without that of the time step;
/// - the **converged** reference is the limit of all consistent methods for small steps. The difference is the whole
///   error.
///
/// A method can be close to one and far from the other, so they are never mixed.
enum class ReferenceKind {
  SameStep,
  Converged,
  Solver  ///< another solver with the same settings, without a check
};

/// One halving of the step of the converged reference.
struct Halving {
  double timeStep = 0.0;    ///< after the halving [s]
  double difference = 0.0;  ///< largest mean distance from the previous run over the checkpoints [m]
  int trusted = 0;          ///< number of checkpoints from the start with a distance below the tolerance
};

/// A reference and its own estimated error.
struct Reference {
  ReferenceKind kind = ReferenceKind::Solver;
  settings::Settings settings;  ///< of its run
  Trajectory trajectory;
  /// The distance of each checkpoint from the run with twice the step [m]; empty except for the converged reference.
  /// The remaining error is about a third of it for a second-order method, and about equal to it for a first-order one.
  std::vector<double> differences;
  std::vector<Halving> halvings;  ///< all halvings
  int trusted = 0;                ///< number of checkpoints from the start that passed the check
  std::string doubt;              ///< its problem, in words; empty when all checkpoints passed
};

/// When the halving of the step ends: at each checkpoint the mean distance between the last two runs is at most
/// `absolute`, or at most `share` of the distance between the last one and the run that is compared.
struct ConvergenceTolerance {
  double absolute = 1e-6;                ///< [m]
  double share = 1e-3;                   ///< [-]
  const Trajectory* compared = nullptr;  ///< a free run; null: only `absolute` counts
  int maxHalvings = 12;
  /// Return the result even when the first checkpoint fails; the differences show its quality.
  bool takeAnyway = false;
  double maxCost = 5e8;  ///< springs times steps of a run [-], about half a minute; a longer one is not started
};

/// The settings of the same-step reference for a method's: solver newton, tolerance 1e-10.
[[nodiscard]] settings::Settings sameStepSettings(settings::Settings settings);

/// The settings from which the converged reference starts: solver verlet in double, backward Euler's integration, no
/// substeps.
[[nodiscard]] settings::Settings convergedSettings(settings::Settings settings);

/// Runs the reference with `settings` and checks that every solve reached its tolerance. Throws InputError when it
/// blows up before the first checkpoint.
[[nodiscard]] Reference sameStepReference(const scene::Scene& scene, const settings::Settings& settings,
                                          int checkpoints, const Progress& progress = {});

/// Starts with a step below half of the solver's stability limit (and at most the settings' own), then halves the step
/// until every checkpoint meets the tolerance. It stops where halving no longer helps, as in chaotic motion, and
/// reports that time. Throws InputError when the first checkpoint does not converge, unless that is allowed.
[[nodiscard]] Reference convergedReference(const scene::Scene& scene, const settings::Settings& settings,
                                           int checkpoints, const ConvergenceTolerance& tolerance,
                                           const Progress& progress = {});

/// Runs another solver without any check.
[[nodiscard]] Reference solverReference(const scene::Scene& scene, const settings::Settings& settings, int checkpoints,
                                        const Progress& progress = {});

}  // namespace drape::report
