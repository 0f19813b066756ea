#pragma once

#include "sim/adaptive/adaptive_run.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/model_cache.hpp"

#include <vector>

namespace drape::sim::adaptive {

/// An upper bound of the work of wind on a cloth in a step [J]: the force bound times the distance that the wind
/// covers.
[[nodiscard]] double maxWindWork(const LocalRates& rates, const CommonParameters& parameters);

/// Removes up to `energy` [J] from the inner motion of a cloth (sim/motion/inner_motion.hpp). Momentum does not change.
/// @return the energy removed [J]
double removeInnerMotion(const ClothModel& model, const std::vector<std::vector<std::size_t>>& freePieces,
                         double energy, ClothState& state);

/// Limits the energy drift of a cloth (docs/theory/auto.md). It sums two drifts in the memory of the state:
/// - The drift of the energy that a stable scheme conserves, from the first to the last substep. If it grows, the step
///   must be retried. Oscillations do not count.
/// - The drift of the visible energy 1/2 m v.v + V(x) at the ends of steps. It may be at most 0.4 % of the reference
///   energy; kinetic energy above that is removed, from the rates of stretch first. Changes between two steps, by
///   contact, pins or settings, do not count, but changes of the stiffness of softened springs do.
/// Where springs are softened, the visible energy with their full stiffness has a third drift. While that is too large,
/// energy is removed from the rates of stretch only: the weight stretches soft springs further than the full stiffness
/// would allow.
class EnergyGuard {
 public:
  /// Prepares for a step from `state`.
  /// @param roundoff unit roundoff of the step's precision [-]  @param origin of its positions (simd::stepOrigin) [m]
  void prepare(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
               const ClothState& state, double roundoff, const Vec3& origin);

  /// Whether the energy at the start of the step is known: it is then the energy at the end of the previous step.
  [[nodiscard]] bool isStartEnergyKnown(const StepPlan& plan, const StepMemory& memory) const;

  /// Whether coarse levels store more energy than the weight and the motion of the cloth can have put into them, as in
  /// crumpled or reflected cloth. This energy would go into the softened springs, whose visible energy is many times
  /// their own. The step should then not use levels.
  /// @param levels energy of the levels at the start [J]  @param motionExplains whether the motion of the cloth counts:
  /// if the levels were dropped before, it has its energy from them
  [[nodiscard]] bool levelsStoreTooMuch(const ClothModel& model, const ClothState& state, double levels,
                                        bool motionExplains) const;

  /// Whether to measure the energy at the end of the step, which costs a force evaluation. In steps of few evaluations
  /// it is not measured every time, unless wind acts, the drift is large or a step was retried recently.
  [[nodiscard]] bool isMeasurementDue(const StepPlan& plan, const StepMemory& memory) const;

  /// True if the energy is not finite, or grew by more than external work explains. Updates the drift in `memory`.
  /// @param work upper bound of the external work [J]  @param isRetry whether the step is a retry
  [[nodiscard]] bool hasGrown(const StepEnergy& energy, double work, bool isRetry, StepMemory& memory) const;

  /// Adds an accepted step, which ended in `state`, and removes kinetic energy if the drift is too large. Updates
  /// `memory`.
  void store(const ClothModel& model, const CommonParameters& parameters, const StepPlan& plan,
             const StepEnergy& energy, double work, StepMemory& memory, ClothState& state);

 private:
  void limitVisibleDrift(const ClothModel& model, const StepEnergy& energy, double start, double work, double removed,
                         StepMemory& memory, ClothState& state) const;

  /// The reference energy that drifts are compared with [J].
  [[nodiscard]] double referenceEnergy(double startEnergy, double fallFraction) const;

  ModelCache<std::vector<std::vector<std::size_t>>> pieces_;
  double fallEnergy_ = 0.0;        // m g D, the energy of a fall by the cloth's diagonal [J]
  double roundingEnergy_ = 0.0;    // energy of rounding errors, times a margin [J]
  double startPotential_ = 0.0;    // potential energy at the start [J]
  double translation_ = 0.0;       // kinetic energy of free cloth as a whole at the start [J]
  std::uint64_t fingerprint_ = 0;  // of the state and the settings at the start
  bool dissipates_ = false;        // damping or air remove energy
  double airEnergy_ = 0.0;         // 1/2 m w^2 of free cloth in wind of speed w [J]
  double maxWindWork_ = 0.0;       // bound of the magnitude of the wind's work [J]
};

}  // namespace drape::sim::adaptive
