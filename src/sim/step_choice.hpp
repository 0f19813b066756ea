#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace drape {

/// How far the work allowed is exceeded without a word: by that much the estimate of what is stable may be off.
inline constexpr double toleratedCostRatio = 1.6;

/// What a method that chooses for itself chose for a step, and what it thinks of it.
struct StepChoice {
  int order = 2;             ///< of the explicit scheme: 2 (Verlet) or 4 (PEFRL); 1 when the last resort took the step
  int substeps = 1;          ///< equal parts that the step was taken in [-]
  int forceEvaluations = 1;  ///< evaluations of all springs, coarse levels as what they cost; with retakes [-]
  double hOmega = 0.0;       ///< time step times the mesh's largest local frequency [-]
  double costRatio = 0.0;    ///< what the step was planned to cost, in the work allowed for it [-]
  double stiffnessScale = 1.0;  ///< share of their stiffness that the springs of the median vertex keep [-]
  int coarseLevels = 0;         ///< coarse levels that carry tension [-]
  int retries = 0;              ///< how often the energy guard had the step taken again [-]
  bool usedFallback = false;    ///< the energy guard gave the step to a method that cannot explode
  bool sleeping = false;        ///< the cloth rests, so that there was nothing to do
  double error = -1.0;       ///< estimated mean position error after 0.2 s of such steps [m]; negative: not known yet
  double energyDrift = 0.0;  ///< energy that came from nowhere lately and has not gone again [J]

  /// Takes in the choice of the step that follows.
  void add(const StepChoice& next);
};

/// The choice in a sentence: "stiff cloth: 12 explicit substeps, 0.4 ms of 16 ms, error about 0.2 mm".
/// @param seconds what the step cost [s]  @param available what it may cost to keep up with the clock [s]; both 0 when
/// they are not known, and then not told
[[nodiscard]] std::string inWords(const StepChoice& choice, double seconds = 0.0, double available = 0.0);

/// All of it by name, as programs read it ("order", "substeps", ..., "last_resort" and "resting" as 0 or 1).
[[nodiscard]] std::vector<std::pair<std::string_view, double>> figuresOf(const StepChoice& choice);

}  // namespace drape
