#pragma once

#include "sim/model/cloth_state.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace drape::sim::adaptive {

/// The memory of StretchChoice for one material of a fabric.
struct StretchMemory {
  int level = 0;            ///< of the stretch stiffness, see StretchChoice::scaleOf [-]
  double strain = 0.0;      ///< the last measured strain [-]
  double imposed = 0.0;     ///< the strain that the stiffness does not reduce [-]
  double raisedFrom = 0.0;  ///< the strain before the stiffness was raised [-]; 0: its effect is known
  double changed = 0.0;     ///< time of the last change of the level, or of strain close to the limit [s]
  double peak = 0.0;        ///< the largest strain measured since `changed`, without the imposed strain [-]
};

/// StepMemory::tautEnergy before the first implicit step [J].
inline constexpr double unknownEnergy = std::numeric_limits<double>::infinity();

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
  /// The part of the plan in `fingerprint`: the stiffness of softened springs; 0: they have their full stiffness.
  std::uint64_t planFingerprint = 0;
  /// Energy that changes of the stiffness of softened springs have added and that is still to be removed; negative:
  /// that they have taken [J].
  double stiffeningEnergy = 0.0;
  double visibleEnergy = 0.0;  ///< as `energy`, with the full stiffness of softened springs, without coarse levels [J]
  double visibleDrift = 0.0;   ///< drift of `visibleEnergy` [J]
  /// One more than the number of steps that are still to be taken without coarse levels; 1: the next step tries whether
  /// they still store too much; 0: they did not [-].
  int withoutLevels = 0;
  bool taut = false;                  ///< the pins hold the cloth taut (isTaut)
  std::uint64_t tautFingerprint = 0;  ///< of the pins and settings of that test; 0: not tested yet
  int tautSteps = 0;                  ///< steps until the next test is allowed [-]
  double tautEnergy = unknownEnergy;  ///< the energy that implicit steps may not exceed, with the work of the wind [J]
  /// Root mean square of the vertices' displacements in the last step, divided by its duration [m/s].
  /// Vibration hardly contributes.
  double speed = 0.0;
  int doubleSteps = 0;   ///< number of steps that are still to be taken in double, after the energy grew in float [-]
  int everySubstep = 0;  ///< number of steps in which bending and air are still to act in every substep [-]
  std::vector<StretchMemory> stretch = {};  ///< one for each of fabric::TriangleMaterials::list; empty: not chosen yet
  double strainsMeasured = 0.0;             ///< time of the last measurement of StretchMemory::strain [s]
  /// Positions at `sleepReferenceTime`, near which the vertices have stayed since [m]; null: they move.
  std::shared_ptr<const std::vector<Vec3>> sleepReference = {};
  double sleepReferenceTime = 0.0;     ///< [s]
  std::uint64_t sleepFingerprint = 0;  ///< of everything that acts on the sleeping cloth; 0: it does not sleep
  bool disturbed = false;              ///< cloth in wind was disturbed at `sleepReferenceTime` (SleepDetection)
  /// Positions at `settlingReferenceTime`, from which settle() measures the motion [m]; null: it does not measure.
  std::shared_ptr<const std::vector<Vec3>> settlingReference = {};
  double settlingReferenceTime = 0.0;  ///< [s]
  int slowIntervals = 0;               ///< the last intervals in which the cloth hardly moved, see settle() [-]
};

/// The memory in a state; a new one if the state has none.
[[nodiscard]] StepMemory stepMemoryOf(const ClothState& state);

/// Puts a memory into a state. Copies of the state keep theirs.
void storeStepMemory(StepMemory memory, ClothState& state);

}  // namespace drape::sim::adaptive
