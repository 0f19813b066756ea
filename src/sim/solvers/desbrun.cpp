#include "sim/solvers/common_warnings.hpp"
#include "sim/solvers/filtered_step.hpp"
#include "sim/solvers/registry.hpp"

namespace drape::sim {

/// Desbrun, Schroeder and Barr (1999): a constant matrix filters the internal forces, but not the external ones. The
/// rotation that the filter adds is removed from the positions (filtered_step.hpp has the equations).
///
/// - Paper: the correction (x_G - x_i) x (h T) h^2 / m lacks an inverse inertia, so its unit is not a length. Here: the
///   rigid rotation that cancels the torque exactly, h c_i, added to the positions only.
/// - Paper: a last pass shortens overlong springs (as Provot, 1995). It changes the material and would hide the effect
///   of the integration, so it is left out. We could not establish whether the velocities are recomputed from the
///   corrected positions. If they are, the correction changes the velocities too; that is `meyer`.
/// - A correction of the positions alone conserves the orientation, but not the angular momentum.
SolverInfo solvers::desbrun() {
  return {
      .name = "desbrun",
      .title = "Desbrun constant filter",
      .help =
          "A constant inverse matrix filters the spring forces, but not gravity and wind. For free cloth the rotation "
          "that the filter adds is removed from the positions. A step costs one product with a dense matrix (8 n^2 "
          "bytes for n free vertices; a sparse factor above 4096). The setup takes up to seconds on fine meshes. It is "
          "repeated when the time step, stiffness, damping, mass or pins change, so do not drag their sliders. Stable "
          "at large steps. Folds are stiff, and springs at pins are too long by h^2 g.",
      .source = "Desbrun, Schroeder and Barr (1999), Interactive animation of structured deformable objects",
      .backwardEuler = false,
      .settings = {},
      .warning = stiffFoldsWarning,
      .make = []() -> std::unique_ptr<Solver> {
        return std::make_unique<FilteredStepSolver>(RotationCorrection::Positions);
      }};
}

}  // namespace drape::sim
