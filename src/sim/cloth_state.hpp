#pragma once

#include "sim/vector.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace drape {

struct SelfContactMemory;

/// The state before the last step, for integrations that look back further than one step.
struct StepHistory {
  std::vector<Vec3> positions;   ///< [m], one a vertex
  std::vector<Vec3> velocities;  ///< [m/s], one a vertex
  double timeStep = 0.0;         ///< of the step from there to here [s]; 0: there is no history
};

/// What a method that chooses for itself has learnt on the way. Part of the state, so that a copy goes on the same way.
struct StepMemory {
  double forceEvaluations =
      0.0;              ///< evaluations of all springs that a step should have for its tolerance [-]; 0: not known yet
  double error = -1.0;  ///< estimated mean position error after 0.2 s of such steps [m]; negative: not known yet
  int steps = 0;        ///< taken since there is something to remember [-]
  int retryLevel = 0;   ///< how often the energy guard lately had a step taken again [-]
  int calmSteps = 0;    ///< steps since then [-]
  double schemeEnergyDrift =
      0.0;  ///< energy that the last substeps' scheme made from nothing and that has not gone again [J]
  double energyDrift = 0.0;       ///< the same at the ends of the steps [J]
  double energy = 0.0;            ///< that the last step ended with [J]
  std::uint64_t fingerprint = 0;  ///< of the state and the settings that this is the energy of; 0: not known
  /// Where the vertices were at `anchorTime`, and have stayed near ever since [m]; null: they move.
  std::shared_ptr<const std::vector<Vec3>> sleepReference = {};
  double sleepReferenceTime = 0.0;  ///< [s]
  std::uint64_t sleepFingerprint =
      0;  ///< the mark of all that acts on a cloth that rests at its anchor; 0: it does not rest
};

/// What changes while a cloth moves. Plain data: a copy is a checkpoint.
struct ClothState {
  std::vector<Vec3> positions;                                ///< [m], one a vertex
  std::vector<Vec3> velocities;                               ///< [m/s], one a vertex
  double time = 0.0;                                          ///< simulated time since the start [s]
  StepHistory history = {};                                   ///< kept only by integrations that use it
  std::shared_ptr<const SelfContactMemory> selfContact = {};  ///< kept only by self-collision
  StepMemory memory = {};                                     ///< kept only by methods that choose for themselves
};

/// A state at rest in the given positions at time 0.
[[nodiscard]] ClothState stateAtRest(std::vector<Vec3> positions);

/// Moves what is pinned (one entry a vertex) by `by` [m], and nothing else.
void movePins(const std::vector<bool>& pinned, const Vec3& by, ClothState& state);

/// True when every position [m] and velocity [m/s] is a number of at most 1e15, so that its square is finite in float.
[[nodiscard]] bool isFinite(const ClothState& state);

/// A 64-bit FNV-1a hash over the bits of positions and velocities: equal states have equal hashes, and two runs agree
/// to the last bit when their hashes do.
[[nodiscard]] std::uint64_t stateHash(const ClothState& state);

/// The hash as 16 hexadecimal digits.
[[nodiscard]] std::string toHex(std::uint64_t hash);

}  // namespace drape
