#pragma once

#include "sim/adaptive/coarse_motion.hpp"
#include "sim/adaptive/contact_impulses.hpp"
#include "sim/adaptive/step_plan.hpp"
#include "sim/model/model_cache.hpp"
#include "sim/simd/damping_stages.hpp"
#include "sim/simd/slice_step.hpp"
#include "sim/simd/sliced_cloth_cache.hpp"
#include "sim/simd/thread_team.hpp"

#include <memory>
#include <vector>

namespace drape::sim::adaptive {

/// The energy in a step: kinetic, potential, of the clamped springs and of the coarse levels.
///
/// In the middle of the first and the last substep it is 1/2 m v.v' + V(x), with v and v' the velocities before and
/// after the kick at x. It follows from forces that are evaluated anyway. A stable scheme conserves it, except for the
/// work of damping, air, attachment and contacts. At the ends of the step it is 1/2 m v.v + V(x), with the full
/// stiffness of the springs unless they are softened. This energy oscillates by up to (h omega)^2 / 4 of the vibration
/// energy.
struct StepEnergy {
  double first = 0.0;  ///< in the middle of the first substep [J]
  double last = 0.0;   ///< in the middle of the last substep [J]
  double start = 0.0;  ///< at the start of the step, if requested [J]
  double end = 0.0;    ///< at the end of the step, if requested [J]
  bool ends = false;   ///< `start` and `end` are known
  /// If springs are softened: as `start` and `end`, with the full stiffness of these springs and without coarse levels
  /// [J].
  double visibleStart = 0.0;
  double visibleEnd = 0.0;
  double levels = 0.0;             ///< part of `start` in the coarse levels, if `start` was requested [J]
  double contactWork = 0.0;        ///< of contacts in the substeps [J]
  double contactWorkToLast = 0.0;  ///< the same up to the middle of the last substep [J]
};

/// The ends of a step at which to measure the energy. Each measurement costs a force evaluation.
struct EnergyRequest {
  bool start = false;
  bool end = false;
};

/// Takes a step of a cloth by a plan, with vector instructions and in the precision of T. A substep consists of one or
/// several stages: a kick, which changes velocities by the forces, damping stages if damping is split, the drift of the
/// positions, and the impulses of contacts (ContactImpulses).
template <typename T>
class AdaptiveRun {
 public:
  /// Takes a step from `state`, which does not change. Call `store` for the result. Throws StepStopped when
  /// `inputs.stop` asks to stop.
  StepEnergy run(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
                 const StepInputs& inputs, const StepPlan& plan, const ClothState& state, EnergyRequest request);

  /// Writes positions and velocities at the end of the last step. `state` is the state at its start.
  void store(ClothState& state);

  /// Writes the impulses of the last step into its contacts.
  void storeContacts(const StepInputs& inputs) const;

  /// Wall-clock time of contacts in the substeps of all steps so far [s].
  [[nodiscard]] double contactSeconds() const { return contactSeconds_; }

  /// Number of coarse levels in use.
  [[nodiscard]] int levels() const { return activeLevels_; }

 private:
  /// The inputs of the stiffness scales of a model. The scales are computed again only when these change.
  struct StiffnessClamp {
    double hOmegaLimit = -1.0;
    double substep = 0.0;
    double stiffness = 0.0;
    bool usesCoarseLevels = false;

    bool operator==(const StiffnessClamp&) const = default;
  };

  void clampStiffness(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
                      const StepPlan& plan);
  void move(const ClothModel& model, const StepInputs& inputs, const StepPlan& plan, double substep,
            const simd::StepShare& share);
  void kick(const simd::SliceStep<T>& step, const StepPlan& plan, T drift, double* coarseEnergy,
            const simd::StepShare& share);
  void prepareSplitDamping(const ClothModel& model, const LocalRates& rates);
  void damp(double drift, const simd::StepShare& share);
  void resolveContacts(double time, double drift, bool isLast, const simd::StepShare& share);
  void measure(const StepPlan& plan, std::vector<T>& energy, double& coarseEnergy, const simd::StepShare& share);
  void measureVisible(StepPlan plan, std::vector<T>& energy, const simd::StepShare& share);

  simd::ThreadTeam team_;
  simd::SlicedClothCache<T> cloths_;
  simd::SlicedCloth<T>* cloth_ = nullptr;
  ModelCache<std::unique_ptr<CoarseMotion<T>>> coarse_;
  CoarseMotion<T>* motion_ = nullptr;
  ModelCache<StiffnessClamp> clamps_;
  std::vector<simd::SliceNumbers<T>> stiffnessScales_;
  int activeLevels_ = 0;
  simd::SliceStep<T> step_;
  ModelCache<std::vector<simd::SliceNumbers<T>>> dampingScales_;  // empty: all are 1
  simd::DampingRun<T> damping_;  // of a substep; no stages: damping is part of the kick
  simd::LaneVectors<T> gain_;    // velocity change of a kick, for the damping stages [m/s]
  ContactImpulses<T> contacts_;
  double contactWorkToLast_ = 0.0;  // [J]
  double contactSeconds_ = 0.0;     // see contactSeconds()
  std::vector<T> firstEnergy_;
  std::vector<T> lastEnergy_;
  std::vector<T> startEnergy_;
  std::vector<T> endEnergy_;
  std::vector<T> visibleStart_;
  std::vector<T> visibleEnd_;
  double firstCoarse_ = 0.0;  // [J]
  double lastCoarse_ = 0.0;   // [J]
  double startCoarse_ = 0.0;  // [J]
  double endCoarse_ = 0.0;    // [J]
};

}  // namespace drape::sim::adaptive
