#pragma once

namespace drape::sim::adaptive {

/// The options of the solver `auto`.
struct AutoOptions {
  double costBudget = 500.0;  ///< spring evaluations per simulated second [1e6/s]
  bool soften = false;        ///< keeps to the cost budget by softer springs; else a step may exceed it
  /// Strain along warp and weft up to which a fabric's stretch stiffness may be lowered to keep to the cost budget [-];
  /// 0: never (StretchChoice).
  double strainLimit = 0.0;
  double errorTolerance = 1e-4;  ///< allowed mean position error after 0.2 s of motion [m]
  /// Divides the contact substeps, and multiplies the substeps in each, for a more accurate motion to compare with [-].
  int refinement = 1;
  /// Takes the lift of eq. 20 in full, in place of at most that of a thin plate, for a motion to compare with.
  bool fullLift = false;
};

}  // namespace drape::sim::adaptive
