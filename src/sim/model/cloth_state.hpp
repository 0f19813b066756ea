#pragma once

#include "sim/model/vector.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace drape::sim {

namespace contact {
struct SelfContactMemory;
}

/// The state before the last step, for multistep integrations.
struct StepHistory {
  std::vector<Vec3> positions;   ///< [m], one a vertex
  std::vector<Vec3> velocities;  ///< [m/s], one a vertex
  double timeStep = 0.0;         ///< of the step from that state to the present one [s]; 0: there is no history
};

/// What a solver remembers from earlier steps. Each solver that needs it derives its own type. The memory never
/// changes, since copies of a state share it: the solver replaces it.
struct SolverMemory {
  SolverMemory() = default;
  SolverMemory(const SolverMemory&) = delete;
  SolverMemory& operator=(const SolverMemory&) = delete;
  virtual ~SolverMemory() = default;
};

/// The variable data of a cloth. Plain data: a copy is a checkpoint.
struct ClothState {
  std::vector<Vec3> positions;                                         ///< [m], one a vertex
  std::vector<Vec3> velocities;                                        ///< [m/s], one a vertex
  double time = 0.0;                                                   ///< simulated time since the start [s]
  StepHistory history = {};                                            ///< used by multistep integrations only
  std::shared_ptr<const contact::SelfContactMemory> selfContact = {};  ///< used by self-collision only
  /// Whether no two triangles intersect, as exact self-collision found in the last step. False: the next step checks.
  bool hasNoSelfIntersection = false;
  std::shared_ptr<const SolverMemory> memory = {};  ///< used by `auto` only; null: there is none yet
};

/// A state at rest in the given positions at time 0.
[[nodiscard]] ClothState stateAtRest(std::vector<Vec3> positions);

/// Moves the pinned vertices (one entry a vertex) by `by` [m].
void movePins(const std::vector<bool>& pinned, const Vec3& by, ClothState& state);

/// Whether the absolute value of every coordinate is at most `limit`; false for NaN.
[[nodiscard]] bool areWithin(const std::vector<Vec3>& vectors, double limit);

/// True if every coordinate [m] and velocity component [m/s] is at most 1e15 in size, so that its square is finite in
/// float.
[[nodiscard]] bool isFinite(const ClothState& state);

/// A 64-bit FNV-1a hash of the bits of positions and velocities. Two runs are bitwise equal if their hashes are.
[[nodiscard]] std::uint64_t stateHash(const ClothState& state);

/// The hash as 16 hexadecimal digits.
[[nodiscard]] std::string toHex(std::uint64_t hash);

}  // namespace drape::sim
