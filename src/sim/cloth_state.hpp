#pragma once

#include "sim/vector.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace drape {

struct SelfContactMemory;

/// The state before the last step, for multistep integrations.
struct StepHistory {
  std::vector<Vec3> positions;   ///< [m], one a vertex
  std::vector<Vec3> velocities;  ///< [m/s], one a vertex
  double timeStep = 0.0;         ///< of the step from that state to the present one [s]; 0: there is no history
};

/// The memory of the solver `auto`. It is part of the state, so that a copy of the state continues identically.
struct StepMemory {
  double forceEvaluations = 0.0;   ///< of a step, for the error tolerance [-]; 0: not known yet
  double error = -1.0;             ///< estimated mean position error after 0.2 s [m]; negative: not known yet
  int steps = 0;                   ///< count of steps for estimates, cyclic after the first ones [-]
  int retryLevel = 0;              ///< steps start with the plan of this retry [-]
  int calmSteps = 0;               ///< steps since the last retry [-]
  double schemeEnergyDrift = 0.0;  ///< drift of the energy that a stable scheme conserves, at least 0 [J]
  double energyDrift = 0.0;        ///< drift of the energy at the ends of steps [J]
  double energy = 0.0;             ///< at the end of the last step [J]
  std::uint64_t fingerprint = 0;   ///< of the state and the settings that `energy` belongs to; 0: not known
  /// Positions at `sleepReferenceTime`, near which the vertices have stayed since [m]; null: they move.
  std::shared_ptr<const std::vector<Vec3>> sleepReference = {};
  double sleepReferenceTime = 0.0;     ///< [s]
  std::uint64_t sleepFingerprint = 0;  ///< of everything that acts on the sleeping cloth; 0: it does not sleep
};

/// The variable data of a cloth. Plain data: a copy is a checkpoint.
struct ClothState {
  std::vector<Vec3> positions;                                ///< [m], one a vertex
  std::vector<Vec3> velocities;                               ///< [m/s], one a vertex
  double time = 0.0;                                          ///< simulated time since the start [s]
  StepHistory history = {};                                   ///< used by multistep integrations only
  std::shared_ptr<const SelfContactMemory> selfContact = {};  ///< used by self-collision only
  StepMemory memory = {};                                     ///< used by `auto` only
};

/// A state at rest in the given positions at time 0.
[[nodiscard]] ClothState stateAtRest(std::vector<Vec3> positions);

/// Moves the pinned vertices (one entry a vertex) by `by` [m].
void movePins(const std::vector<bool>& pinned, const Vec3& by, ClothState& state);

/// True if every coordinate [m] and velocity component [m/s] is at most 1e15 in size, so that its square is finite in
/// float.
[[nodiscard]] bool isFinite(const ClothState& state);

/// A 64-bit FNV-1a hash of the bits of positions and velocities. Two runs are bitwise equal if their hashes are.
[[nodiscard]] std::uint64_t stateHash(const ClothState& state);

/// The hash as 16 hexadecimal digits.
[[nodiscard]] std::string toHex(std::uint64_t hash);

}  // namespace drape
