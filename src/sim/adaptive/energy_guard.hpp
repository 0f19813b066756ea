#pragma once

#include "sim/adaptive/adaptive_run.hpp"
#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/model_cache.hpp"
#include "sim/step_parameters.hpp"

#include <vector>

namespace drape {

/// A bound of what wind does to a cloth in a step [J]: the air's force on all of its area, as fast as the wind.
[[nodiscard]] double mostWorkOfWind(const LocalRates& rates, const StepParameters& parameters);

/// Slows the inner motion of a cloth (sim/inner_motion.hpp) down by so much energy [J], or to nothing. Momentum stays.
/// @return how much it took [J]
double slowDown(const ClothModel& model, const std::vector<std::vector<std::size_t>>& freePieces, double energy,
                ClothState& state);

/// Keeps a cloth from getting energy that nothing gave it. It holds two accounts, both in the state's memory:
/// - of the energy that a stable scheme keeps, from the first to the last substep. Where that grows, the step is to be
///   taken again, more carefully. What comes and goes does not count;
/// - of the energy at the ends of the steps, which everybody sees. It may not rise by more than 0.4 % of what there is
///   in all; what is above that is taken out of the motion. What is done to the cloth between two steps, by contact,
///   pins or settings, does not count.
class EnergyGuard {
 public:
  /// Looks at the cloth before a step. @param roundoff the unit roundoff of the numbers it is calculated with [-]
  void begin(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
             const ClothState& state, double roundoff);

  /// Whether the energy that it starts with, under this plan, is what the step before ended with.
  [[nodiscard]] bool knowsStart(const StepPlan& plan, const StepMemory& memory) const;

  /// Whether the energy at the end of a step is to be looked at, which costs a pass. Where a step takes a few passes
  /// only, calm cloth that nothing works at is looked at now and then.
  [[nodiscard]] bool isDue(const StepPlan& plan, const StepMemory& memory) const;

  /// True when the energy is no number, or grew and nothing can have done it.
  /// @param work that may have been done from outside [J]  @param again the step has been taken again
  [[nodiscard]] bool grew(const StepEnergy& energy, double work, bool again, StepMemory& memory) const;

  /// Books a step, which `state` is the end of, and slows the cloth down where it gained too much.
  void book(const ClothModel& model, const StepParameters& parameters, const StepPlan& plan, const StepEnergy& energy,
            double work, ClothState& state);

 private:
  [[nodiscard]] double scaleOf(double startEnergy, double ofFall) const;

  ModelCache<std::vector<std::vector<std::size_t>>> pieces_;
  double weight_ = 0.0;     // m g D, what falling by the cloth's own size sets free [J]
  double rounding_ = 0.0;   // what rounding alone may look like, times what it is held against [J]
  double lifted_ = 0.0;     // potential energy at the start [J]
  std::uint64_t mark_ = 0;  // of the state and the settings that the step begins with
  bool fades_ = false;      // damping or air take energy
  bool windy_ = false;      // wind may do work
};

}  // namespace drape
