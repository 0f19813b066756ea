#pragma once

#include "scene/scene.hpp"
#include "sim/energy_balance.hpp"

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace drape {

/// Time between two checkpoints, the paper's [s].
inline constexpr double checkpointInterval = 1.0 / 30.0;

/// Called while a run goes on, within long steps too: what runs, steps done, steps in all. What it throws ends the run.
using Progress = std::function<void(std::string_view label, std::int64_t done, std::int64_t total)>;

/// A run, seen at its checkpoints.
struct Trajectory {
  std::vector<ClothState> states;       ///< [k] at k/30 s; [0] is the start
  std::vector<EnergyBalance> balances;  ///< [k] from the start to there; if restarted, over the last interval only
  int stepsPerCheckpoint = 0;
  bool restarted = false;            ///< each interval began where the reference was
  bool finite = true;                ///< false: it blew up, and ends at the last checkpoint that is finite
  std::int64_t unsolvedSteps = 0;    ///< whose solve gave up before its tolerance
  double largestResidual = 0.0;      ///< that a step reported, of its last solve [-]
  double largestEnergy = 0.0;        ///< total energy after any step, or of the start [J]; only when asked for
  double largestStepResidual = 0.0;  ///< nonlinearResidual of a step [-]; only when asked for

  [[nodiscard]] int checkpoints() const { return static_cast<int>(states.size()) - 1; }
};

/// What to watch while running.
struct Watch {
  bool energy = false;         ///< fill Trajectory::balances
  bool energyPeak = false;     ///< fill Trajectory::largestEnergy
  bool stepResiduals = false;  ///< fill Trajectory::largestStepResidual: what backward Euler without parts leaves
  std::string_view label = "simulating";
  Progress progress = {};  ///< may be empty
};

/// How many steps there are from one checkpoint to the next. Throws UsageError naming the nearest steps that fit when
/// 1/30 s is not a whole number of them (to a millionth).
[[nodiscard]] int stepsPerCheckpoint(double timeStep);

/// The number of checkpoints in that time [s], the nearest whole number. Throws UsageError when there is none.
[[nodiscard]] int checkpointsIn(double seconds);

/// Runs the scene's cloth under these settings, without a hand. The scene's mesh, masses and pins are as built.
[[nodiscard]] Trajectory runTrajectory(const Scene& scene, const Settings& settings, int checkpoints,
                                       const Watch& watch = {});

/// The same, but each interval starts from the reference's positions and velocities at its beginning: the error made
/// within an interval, without what earlier errors grew to. Integrations that look back begin afresh each time.
[[nodiscard]] Trajectory runRestarted(const Scene& scene, const Settings& settings, const Trajectory& reference,
                                      const Watch& watch = {});

}  // namespace drape
