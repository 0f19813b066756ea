#pragma once

#include "report/trajectory.hpp"

#include <string>
#include <vector>

namespace drape {

/// What a method is held against. There are two references, and they answer different questions:
///
/// - the **same-step** reference solves the same step (time step, substeps, integration, derivative) to the end by
///   Newton's method: what is left is the error of the method's own approximation, and none of the time step's;
/// - the **converged** reference is the motion that every good method tends to as its step goes to zero: what is left
///   is the whole error.
///
/// A method can be near one and far from the other. They are never mixed.
enum class ReferenceKind {
  SameStep,
  Converged,
  Solver  ///< another solver under the same settings; nobody vouches for it
};

/// One halving of the converged reference's step.
struct Halving {
  double timeStep = 0.0;    ///< after the halving [s]
  double difference = 0.0;  ///< largest mean distance from the run before it over the checkpoints [m]
  int trusted = 0;          ///< checkpoints from the start at which the distance was below the tolerance
};

/// A reference with what is known of its own error.
struct Reference {
  ReferenceKind kind = ReferenceKind::Solver;
  Settings settings;  ///< it ran under
  Trajectory trajectory;
  /// Distance of each checkpoint from the run with twice the step [m]; empty unless converged was asked for. What is
  /// left to the limit is about a third of that for a method of second order, about as much for one of first.
  std::vector<double> differences;
  std::vector<Halving> halvings;  ///< the way there
  int trusted = 0;                ///< checkpoints from the start that passed its check
  std::string doubt;              ///< what is wrong with it, in words; empty when all of it passed
};

/// When the halving of the converged reference's step may end: at each checkpoint the mean distance between the last
/// two runs is at most `absolute`, or at most `share` of the distance between the last one and the run to be judged.
struct ConvergenceTolerance {
  double absolute = 1e-6;              ///< [m]
  double share = 1e-3;                 ///< [-]
  const Trajectory* judged = nullptr;  ///< runs freely; null: `absolute` alone counts
  int maxHalvings = 12;
  /// Take what there is where not even the first checkpoint passes: the differences tell what it is worth.
  bool takeAnyway = false;
  double maxCost = 5e8;  ///< springs times steps of a run [-], about half a minute; a longer one is not begun
};

/// The settings of the same-step reference for a method's: solver newton, tolerance 1e-10.
[[nodiscard]] Settings sameStepSettings(Settings settings);

/// The settings from which the converged reference starts: solver verlet, backward Euler's integration, no substeps.
[[nodiscard]] Settings convergedSettings(Settings settings);

/// Runs the reference that `settings` describe and looks whether every solve reached its tolerance. Throws InputError
/// when it blows up before the first checkpoint.
[[nodiscard]] Reference sameStepReference(const Scene& scene, const Settings& settings, int checkpoints,
                                          const Progress& progress = {});

/// Runs with the settings' solver at a step below half of its stability limit (and not above the settings' own), then
/// halves the step until the tolerance is met at every checkpoint. Gives up where halving no longer helps, which is the
/// end of what can be known of a chaotic motion, and says from where on. Throws InputError when not even the first
/// checkpoint converges and that is not allowed.
[[nodiscard]] Reference convergedReference(const Scene& scene, const Settings& settings, int checkpoints,
                                           const ConvergenceTolerance& tolerance, const Progress& progress = {});

/// Runs another solver, without a check of it.
[[nodiscard]] Reference solverReference(const Scene& scene, const Settings& settings, int checkpoints,
                                        const Progress& progress = {});

}  // namespace drape
