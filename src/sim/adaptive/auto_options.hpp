#pragma once

namespace drape::sim::adaptive {

/// The options of the solver `auto`.
struct AutoOptions {
  double costBudget = 500.0;  ///< spring evaluations per simulated second [1e6/s]
  bool soften = false;        ///< softens springs to meet the cost budget; otherwise a step may exceed it
  /// Strain along warp and weft up to which a fabric's stretch stiffness may be lowered to keep to the cost budget [-];
  /// 0: never (StretchChoice).
  double strainLimit = 0.0;
  double errorTolerance = 1e-4;  ///< allowed mean position error after 0.2 s of motion [m]
  /// Divides the length of the contact substeps, and multiplies the substeps in each [-]. A more accurate motion for
  /// comparison.
  int refinement = 1;
  /// Does not limit the lift of eq. 20 to that of a thin plate. A motion for comparison.
  bool fullLift = false;
};

}  // namespace drape::sim::adaptive
