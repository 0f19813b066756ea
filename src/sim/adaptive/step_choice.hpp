#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace drape::sim::adaptive {

/// Steps may cost up to this many times the cost budget without a message: the estimate of what stability needs may be
/// wrong by as much.
inline constexpr double toleratedCostRatio = 1.6;

/// The choices of the solver `auto` for a step, with statistics.
struct StepChoice {
  /// Of the scheme: 2 (Verlet) or 4 (PEFRL); 1 for implicit substeps, or if the fallback solver took a part of the
  /// step.
  int order = 2;
  int substeps = 1;          ///< equal parts of the step [-]
  int forceEvaluations = 1;  ///< cost of the step with retries, in evaluations of all springs [-]
  double hOmega = 0.0;       ///< time step times the mesh's largest local frequency [-]
  double costRatio = 0.0;    ///< planned cost over the cost budget of the step [-]
  /// Stiffness scale of the springs at the median vertex, or of the stretch moduli of a fabric's softest material [-];
  /// 1: full stiffness.
  double stiffnessScale = 1.0;
  int softestMaterial = 0;         ///< the index of that material, see fabric::TriangleMaterials::list
  double strain = -1.0;            ///< along warp or weft of a fabric with auto.strain [-]; negative: not measured
  int softenedTriangles = 0;       ///< small triangles of a fabric with auto.strain whose stiffness is lowered [-]
  double fullStiffnessCost = 1.0;  ///< cost of a step with the full stiffness over that of this one [-]
  int coarseLevels = 0;            ///< coarse levels in use [-]
  int retries = 0;                 ///< of the step by the energy guard [-]
  bool inParts = false;            ///< the step was taken in parts, after all retries failed
  bool usedFallback = false;       ///< the fallback solver took the step, or a part of it
  bool sleeping = false;           ///< the cloth sleeps; nothing was computed
  double error = -1.0;             ///< estimated mean position error after 0.2 s [m]; negative: not known yet
  double energyDrift = 0.0;        ///< energy that the integrator has added [J]

  /// Adds the choice of the next step.
  void add(const StepChoice& next);
};

/// All members by name, for JSON ("order", "substeps", ..., "used_fallback" and "sleeping" as 0 or 1).
[[nodiscard]] std::vector<std::pair<std::string_view, double>> figuresOf(const StepChoice& choice);

}  // namespace drape::sim::adaptive
