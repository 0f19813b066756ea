#pragma once

#include "sim/adaptive/auto_options.hpp"
#include "sim/adaptive/step_choice.hpp"
#include "sim/adaptive/step_memory.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/forces/local_rates.hpp"
#include "sim/forces/step_inputs.hpp"
#include "sim/model/cloth_model.hpp"

#include <vector>

namespace drape::sim::adaptive {

/// The largest absolute value of any coordinate relative to an origin [m].
[[nodiscard]] double maxCoordinate(const std::vector<Vec3>& positions, const Vec3& origin);

/// The explicit schemes. Both are symplectic and reversible where forces depend on positions only.
enum class ExplicitScheme {
  Verlet,  ///< second order, one force evaluation a substep
  Pefrl    ///< fourth order, four evaluations (Omelyan, Mryglod and Folk, 2002, Comput. Phys. Commun. 146, 188)
};

/// Errors are given as the position error after this time [s].
inline constexpr double errorTime = 0.2;

/// Cost of a force evaluation with coarse levels, in evaluations without (bench/auto_bench.cpp).
inline constexpr int costWithLevels = 2;

/// Cost of a damping stage, in force evaluations (bench/auto_bench.cpp).
inline constexpr double costOfDampingStage = 0.3;

/// Cost of a substep of the solver one_iteration, in force evaluations.
inline constexpr double costOfImplicitSubstep = 3.5;

/// The scheme and the substeps of a step.
struct StepPlan {
  ExplicitScheme scheme = ExplicitScheme::Verlet;
  int substeps = 1;
  double hOmegaLimit = 0.0;       ///< springs are clamped to this h omega, h being the substep [-]; 0: no clamping
  int dampingStages = 0;          ///< of a substep, for damping too strong for the kick; 0: damping is part of the kick
  bool usesCoarseLevels = false;  ///< coarse levels supply the stiffness that clamping removes
  /// Number of substeps between two kicks by the air and by bending of a fabric [-]. Odd; the first divides the second,
  /// and the second the substeps.
  int airInterval = 1;
  int bendingInterval = 1;
  bool isImplicit = false;  ///< substeps of the solver one_iteration, for taut cloth
  bool softens = false;     ///< the energy counts the clamped stiffness; otherwise the full stiffness
  bool fullLift = false;    ///< the lift of eq. 20 is not limited to that of a thin plate

  [[nodiscard]] int forceEvaluations() const { return scheme == ExplicitScheme::Pefrl ? 4 * substeps : substeps; }
  /// The cost with coarse levels, damping stages and implicit substeps, in force evaluations.
  [[nodiscard]] int cost() const {
    if (isImplicit) {
      return static_cast<int>(costOfImplicitSubstep * substeps);
    }
    return (usesCoarseLevels ? costWithLevels * forceEvaluations() : forceEvaluations()) +
           static_cast<int>(costOfDampingStage * substeps * dampingStages);
  }
};

/// The plan for a retry of a step. Softened springs are first clamped further, since crumpled cloth is faster than its
/// rest shape. All others, and softened springs in the second retry, get twice the substeps. The stiffness of softened
/// springs does not change then: stiffness added to stretched springs would add energy.
[[nodiscard]] StepPlan saferPlan(StepPlan plan);

/// The maximum number of force evaluations of a step that keeps the full stiffness: several seconds of computation.
[[nodiscard]] double maxEvaluations(const ClothModel& model, const CommonParameters& parameters,
                                    const AutoOptions& options);

/// Whether a step of that many force evaluations takes at most 1.6 times as long as one with coarse levels, which take
/// some time in every step (AutoTuning::levelOverhead). @param substeps of the step with coarse levels
[[nodiscard]] bool isHardlySlowerThanLevels(double evaluations, double substeps);

/// Whether springs may be softened: if the user allows it, or if a step with the full stiffness would exceed
/// `maxEvaluations`.
[[nodiscard]] bool maySoften(const ClothModel& model, const CommonParameters& parameters, const AutoOptions& options);

/// The force evaluations that the cost budget allows in a step, at least four.
[[nodiscard]] double evaluationsInBudget(const ClothModel& model, const CommonParameters& parameters,
                                         const AutoOptions& options);

/// The force evaluations of a step with Verlet at the preferred distance from the stability limit
/// (AutoTuning::preferredFraction), without damping stages [-].
[[nodiscard]] double stableEvaluations(const ClothModel& model, const CommonParameters& parameters);

/// The weight, and the part of the wind's force that counts as load [N].
[[nodiscard]] double loadOf(const LocalRates& rates, const CommonParameters& parameters);

/// The cheapest plan that is expected to keep `errorTolerance`, within the cost budget. With B force evaluations and
/// H omega of the time step H (docs/theory/auto.md derives the bounds):
/// - B >= 2 H omega: fourth order, if forces depend on positions only (no damping, air or attachment);
/// - B >= H omega / 2.04: Verlet; also if that costs up to 1.6 times the budget;
/// - smaller B, softening not allowed: as many substeps as all but the fastest hundredth of the vertices need;
/// - smaller B, softening allowed: Verlet with clamped springs;
/// - and where clamped springs keep less than half of their stiffness and the load strains them by 0.001 or more at the
///   pins: half as many substeps, with coarse levels, which double the cost of a substep. Or Verlet with the full
///   stiffness, if that is hardly slower (isHardlySlowerThanLevels). While StepMemory::withoutLevels is above 1,
///   clamped springs without levels, with as many substeps as take the same time;
/// - instead of clamped springs, implicit substeps of the same cost if the cloth is taut (StepMemory::taut), without
///   contacts and attachment.
/// Depends on its arguments only.
[[nodiscard]] StepPlan planStep(const ClothModel& model, const LocalRates& rates, const CommonParameters& parameters,
                                const AutoOptions& options, const StepInputs& inputs, const StepMemory& memory);

/// True if damping may need so many stages in a substep that rounding in float matters.
[[nodiscard]] bool dampingNeedsDouble(const LocalRates& rates, const CommonParameters& parameters);

/// An upper bound of the wind's force on a cloth [N]: the full dynamic pressure on the whole area.
[[nodiscard]] double maxWindForce(const LocalRates& rates, const CommonParameters& parameters);

/// True if rounding to float would add noticeable energy. In each substep a position is rounded by up to
/// d = 2^-24 |x|, which adds about c m omega^2 d^2 / 2 with stiff springs; c = AutoTuning::roundingHeat. Noticeable is
/// 1/500 of the energy of a fall by the cloth's diagonal, in a second. For cloth that damping or still air bring to
/// rest it is the heating that keeps vertices moving at some tenths of a millimetre per second. While contacts act it
/// is the heating that keeps them moving at about 1 mm/s. Cloth that moves visibly does not count as coming to rest.
/// @param maxCoordinate the largest coordinate, relative to simd::stepOrigin [m]
[[nodiscard]] bool roundingAddsEnergy(const ClothModel& model, const LocalRates& rates,
                                      const CommonParameters& parameters, const AutoOptions& options,
                                      const StepMemory& memory, double maxCoordinate, bool contactsAct);

/// True if rounding to float alone would exceed the error tolerance, and the cost budget suffices for double, which
/// costs AutoTuning::doubleCost times as much. If the tolerance is out of reach of the budget: true if the fewer force
/// evaluations that the budget allows in double have a smaller error. They must suffice for the same order. N force
/// evaluations that each round a position x to float cause a mean error of about c 2^-24 |x| sqrt(N);
/// c = AutoTuning::roundingDrift.
/// @param maxCoordinate the largest coordinate, relative to simd::stepOrigin [m]
[[nodiscard]] bool roundingExceedsTolerance(const ClothModel& model, const LocalRates& rates,
                                            const CommonParameters& parameters, const AutoOptions& options,
                                            const StepInputs& inputs, const StepMemory& memory, double maxCoordinate);

/// The stiffness scale of the springs at the median vertex under a plan [-].
[[nodiscard]] double medianStiffnessScale(const LocalRates& rates, const CommonParameters& parameters,
                                          const StepPlan& plan);

}  // namespace drape::sim::adaptive
