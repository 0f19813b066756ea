#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/step_choice.hpp"
#include "sim/step_parameters.hpp"

#include <vector>

namespace drape {

/// How fast each vertex can move, the one in the middle and nearly all.
struct LocalRates {
  std::vector<double> unit;     ///< omega_i^2 / k [1/kg], one a vertex
  std::vector<double> damping;  ///< the rate of damping, lambda_i / C_d [1/kg], one a vertex
  double median = 0.0;          ///< of `unit` [1/kg]
  double most = 0.0;            ///< what all free vertices but the fastest hundredth keep below [1/kg]
  double mostDamping = 0.0;     ///< the same of `damping` [1/kg]
  double diagonal = 0.0;        ///< of the rest shape [m]
  double mass = 0.0;            ///< of the whole cloth [kg]
  double area = 0.0;            ///< likewise [m^2]
  double pinnedLength = 0.0;    ///< of all springs with one end pinned, times their relative stiffness [m]
};

[[nodiscard]] LocalRates localRatesOf(const ClothModel& model);

/// The largest coordinate [m].
[[nodiscard]] double farthestOf(const std::vector<Vec3>& positions);

/// The explicit schemes. Either is symplectic and reversible where forces depend on positions alone.
enum class ExplicitScheme {
  Verlet,  ///< second order, one pass over the springs
  Pefrl    ///< fourth order, four passes (Omelyan, Mryglod and Folk, 2002, Comput. Phys. Commun. 146, 188)
};

/// What an error stands for: the position error after so long [s].
inline constexpr double errorTime = 0.2;

/// What an evaluation of all springs costs when coarse levels take part, in evaluations without (bench/auto_bench.cpp).
inline constexpr int costWithLevels = 2;

/// What a stage of damping by itself costs, in evaluations of all springs (bench/auto_bench.cpp).
inline constexpr double costOfDampingStage = 0.3;

/// How a step is to be taken.
struct StepPlan {
  ExplicitScheme scheme = ExplicitScheme::Verlet;
  int substeps = 1;
  double carried = 0.0;   ///< what h omega the springs are held to, h being the substep [-]; 0: to nothing
  int dampingStages = 0;  ///< that a substep takes for damping too strong to be part of the kick; 0: it is
  bool levels = false;    ///< coarse levels give back what the springs do not carry
  bool softens = false;   ///< held springs are taken for softer ones; else none may be held that the energy shows

  /// Evaluations of all springs.
  [[nodiscard]] int passes() const { return scheme == ExplicitScheme::Pefrl ? 4 * substeps : substeps; }
  /// What they cost with all else, in evaluations without coarse levels.
  [[nodiscard]] int cost() const {
    return (levels ? costWithLevels * passes() : passes()) +
           static_cast<int>(costOfDampingStage * substeps * dampingStages);
  }
};

/// What becomes of a plan when its step has to be taken again. Springs that are softened are held to less at first,
/// since crumpled cloth is faster than its rest shape; all others, and the second time these too, get twice the
/// substeps. Softened springs stay as soft as they are then: stiffness given back to springs that had given way would
/// be energy from nothing.
[[nodiscard]] StepPlan saferThan(StepPlan plan);

/// The passes of a step that lasts as long as anybody waits for one, several seconds of computing.
[[nodiscard]] double passesAtMost(const ClothModel& model, const StepParameters& parameters);

/// Whether cloth may become softer than asked for: when the user says so, or where a step of all its stiffness would
/// take more passes than that.
[[nodiscard]] bool mayBeSoftened(const ClothModel& model, const StepParameters& parameters);

/// The evaluations of all springs that the budget allows for a step, no fewer than four.
[[nodiscard]] double passesInBudget(const ClothModel& model, const StepParameters& parameters);

/// The cheapest plan that is expected to hold `errorTolerance`, as far as the budget goes. With B passes and the
/// frame's hardness H = timeStep omega (docs/theory/auto.md derives the bounds):
/// - B >= 2 H: the fourth order, where nothing but positions matters (no damping, air or hand);
/// - B >= H / 2.04: Verlet; also where that takes up to 1.6 times the budget;
/// - less, and cloth may not be softened: as many substeps as all but the fastest hundredth of the vertices need;
/// - less, and it may: Verlet on springs that are held to what the substep carries;
/// - where that is less than half of their stiffness, and the load stretches them by a thousandth or more at the pins:
///   half as many substeps, since coarse levels take as long again.
/// Depends on its arguments alone.
[[nodiscard]] StepPlan planStep(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                                const StepInputs& inputs, const StepMemory& memory);

/// True when damping may take so many stages in a substep that float is too coarse for them.
[[nodiscard]] bool dampingRounds(const LocalRates& rates, const StepParameters& parameters);

/// A bound of the wind's force on a cloth [N]: its pressure from ahead on all of the area.
[[nodiscard]] double mostForceOfWind(const LocalRates& rates, const StepParameters& parameters);

/// True when rounding to float would warm the cloth up noticeably. A substep h rounds each place by up to
/// d = 2^-24 |x|, which is worth about c m omega^2 d^2 / 2 on stiff springs; c = 0.02 was measured
/// (docs/theory/auto.md). Noticeable is a five-hundredth of the energy that falling by its own size gives the cloth, in
/// a second; for cloth that damping or still air bring to rest it is what keeps vertices moving by some tenths of a
/// millimetre a second.
/// @param farthest the largest coordinate [m]
[[nodiscard]] bool roundingHeats(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                                 double farthest);

/// True when rounding to float would by itself build up more error than the tolerance, and the work allowed has room
/// for a step in double, which costs twice as much. N passes that each round places x to float leave a mean error of
/// about c 2^-24 |x| sqrt(N); c = 0.25 was measured (docs/theory/auto.md).
/// @param farthest the largest coordinate [m]
[[nodiscard]] bool roundingShows(const ClothModel& model, const LocalRates& rates, const StepParameters& parameters,
                                 const StepMemory& memory, double farthest);

/// The share of their stiffness that the springs of the median vertex keep under a plan [-].
[[nodiscard]] double medianShare(const LocalRates& rates, const StepParameters& parameters, const StepPlan& plan);

}  // namespace drape
