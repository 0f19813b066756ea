#pragma once

#include "sim/adaptive/coarse_motion.hpp"
#include "sim/adaptive/step_plan.hpp"
#include "sim/model_cache.hpp"
#include "sim/simd/damping_stages.hpp"
#include "sim/simd/slice_step.hpp"
#include "sim/simd/sliced_cloth_cache.hpp"
#include "sim/simd/thread_team.hpp"

#include <memory>
#include <vector>

namespace drape {

/// The energy of a step: that of the springs as they are held and of the coarse levels, with what moves and what is
/// lifted. At the ends it is that of the springs with all their stiffness, unless they are softened on purpose. In the
/// middle of the first and the last substep it is had by the way, from forces that are evaluated in any case, as 1/2 m
/// v.v' + V(x), which a scheme that is stable keeps but for what damping, air and hand do. At the step's ends it is the
/// one that everybody else sees; there it comes and goes by up to (h omega)^2 / 4 of what vibrates.
struct StepEnergy {
  double first = 0.0;  ///< in the middle of the first substep [J]
  double last = 0.0;   ///< in the middle of the last substep [J]
  double start = 0.0;  ///< where the step begins, when it was asked for [J]
  double end = 0.0;    ///< where it ends, when it was asked for [J]
  bool ends = false;   ///< the two are known
};

/// At which ends of a step its energy is asked for. Each costs a pass over the springs.
struct EnergyLooks {
  bool start = false;
  bool end = false;
};

/// Takes a step of a cloth as a plan says, by vector instructions and in the precision of T.
template <typename T>
class AdaptiveRun {
 public:
  /// Takes a step from `state`, which stays as it is. Call `store` to have the result.
  StepEnergy run(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                 const StepInputs& inputs, const StepPlan& plan, const ClothState& state, EnergyLooks looks);

  /// Gives positions and velocities at the end of the step that was run last. `state` is the one that it began from.
  void store(ClothState& state);

  /// How many coarse levels took part.
  [[nodiscard]] int levels() const { return levelsAtWork_; }

 private:
  /// What the springs of a model keep under a plan; worked out again only when that changes.
  struct Holding {
    double carried = -1.0;
    double substep = 0.0;
    double stiffness = 0.0;
    bool levels = false;

    bool operator==(const Holding&) const = default;
  };

  void hold(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters, const StepPlan& plan);
  void move(const ClothModel& model, const StepInputs& inputs, const StepPlan& plan, double substep,
            const StepShare& share);
  void kick(const SliceStep<T>& step, const StepPlan& plan, T drift, double* coarseEnergy, const StepShare& share);
  void dampBeside(const ClothModel& model, const LocalRates& rates);
  void damp(double drift, const StepShare& share);
  void measure(const StepPlan& plan, std::vector<T>& energy, double& coarseEnergy, const StepShare& share);

  ThreadTeam team_;
  SlicedClothCache<T> cloths_;
  SlicedCloth<T>* cloth_ = nullptr;
  ModelCache<std::unique_ptr<CoarseMotion<T>>> coarse_;
  CoarseMotion<T>* motion_ = nullptr;
  ModelCache<Holding> holdings_;
  std::vector<SliceNumbers<T>> shares_;
  int levelsAtWork_ = 0;
  SliceStep<T> step_;
  ModelCache<std::vector<SliceNumbers<T>>> dampingShares_;  // empty: all springs keep all of their damping
  DampingRun<T> damping_;                                   // of a substep; no stages: it is part of the kick
  LaneVectors<T> gain_;                                     // of velocity in a kick, for the stages of damping [m/s]
  std::vector<T> firstEnergy_;
  std::vector<T> lastEnergy_;
  std::vector<T> startEnergy_;
  std::vector<T> endEnergy_;
  double firstCoarse_ = 0.0;  // [J]
  double lastCoarse_ = 0.0;   // [J]
  double startCoarse_ = 0.0;  // [J]
  double endCoarse_ = 0.0;    // [J]
};

}  // namespace drape
