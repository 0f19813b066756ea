#pragma once

#include "scene/scene.hpp"
#include "sim/measures/energy_balance.hpp"

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace drape::report {

/// Time between two checkpoints, as in the paper [s].
inline constexpr double checkpointInterval = 1.0 / 30.0;

/// Called during a run, also within long steps: label, steps done, steps in all. An exception from it ends the run.
using Progress = std::function<void(std::string_view label, std::int64_t done, std::int64_t total)>;

/// A run, recorded at its checkpoints.
struct Trajectory {
  std::vector<sim::ClothState> states;  ///< [k] at k/30 s; [0] is the start
  std::vector<sim::EnergyBalance>
      balances;  ///< [k] from the start to checkpoint k; if restarted, over the last interval only
  int stepsPerCheckpoint = 0;
  bool restarted = false;            ///< whether each interval started at the reference
  bool finite = true;                ///< false: the cloth blew up, and the run ends at the last finite checkpoint
  std::int64_t unsolvedSteps = 0;    ///< steps whose solve missed its tolerance
  double largestResidual = 0.0;      ///< of the last solve of a step [-]
  double largestEnergy = 0.0;        ///< largest total energy after any step or at the start [J]; only on request
  double largestStepResidual = 0.0;  ///< largest nonlinearResidual of a step [-]; only on request

  [[nodiscard]] int checkpoints() const { return static_cast<int>(states.size()) - 1; }
};

/// What to record during a run.
struct Watch {
  bool energy = false;      ///< fill Trajectory::balances
  bool energyPeak = false;  ///< fill Trajectory::largestEnergy
  bool stepResiduals =
      false;  ///< fill Trajectory::largestStepResidual: the residual of backward Euler without substeps
  std::string_view label = "simulating";
  Progress progress = {};  ///< may be empty
};

/// The number of steps between two checkpoints. Throws UsageError with the nearest valid steps when 1/30 s is not a
/// whole number of steps (to a millionth).
[[nodiscard]] int stepsPerCheckpoint(double timeStep);

/// The number of checkpoints in that time [s], rounded. Throws UsageError when there is none.
[[nodiscard]] int checkpointsIn(double seconds);

/// Runs the scene's cloth with these settings, without attachment. Mesh, masses and pins are those of the scene.
[[nodiscard]] Trajectory runTrajectory(const scene::Scene& scene, const settings::Settings& settings, int checkpoints,
                                       const Watch& watch = {});

/// The same, but each interval starts from the reference's positions and velocities at its beginning: the error made
/// within an interval, without the growth of earlier errors. Multistep integrations start again each time.
[[nodiscard]] Trajectory runRestarted(const scene::Scene& scene, const settings::Settings& settings,
                                      const Trajectory& reference, const Watch& watch = {});

}  // namespace drape::report
