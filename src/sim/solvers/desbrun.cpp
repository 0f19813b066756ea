#include "sim/solvers/filtered_step.hpp"
#include "sim/solvers/registry.hpp"
#include "sim/stability.hpp"

namespace drape {

/// Desbrun, Schroeder and Barr (1999): internal forces filtered by a constant matrix, external ones as they are, and
/// the rotation that the filter brings in taken back from the positions (filtered_step.hpp has the equations).
///
/// - Print: the correction (x_G - x_i) x (h T) h^2 / m, without an inverse inertia, which no choice of units makes a
///   length. Here: the rigid rotation that cancels the torque exactly, h c_i, added to the positions alone.
/// - Print: a last pass that shortens overlong springs (as Provot, 1995). It changes the material and would hide what
///   the integration does, so it is left out of the comparison. If the velocities are to be found again from the
///   corrected positions after it, which we could not establish, the correction reaches the velocities too: that is
///   `meyer`.
/// - The angular momentum is not kept by a correction of positions alone; only the orientation is.
SolverInfo solvers::desbrun() {
  return {
      .name = "desbrun",
      .title = "Desbrun constant filter",
      .help =
          "Spring forces go through a constant matrix that is inverted once, gravity and wind do not; cloth that "
          "nothing holds has its positions turned back by the rotation that the filter brought in. A step costs "
          "one product with a dense matrix (8 n^2 bytes for n free vertices; a sparse factor above 4096). The set-up "
          "takes up to seconds on fine meshes and comes again whenever time step, stiffness, damping, mass or pins "
          "change: do not slide those. It stays calm at large steps, folds stiffly, and hangs "
          "lower at its pins the larger the step is (by h^2 g a spring).",
      .source = "Desbrun, Schroeder and Barr (1999), Interactive animation of structured deformable objects",
      .backwardEuler = false,
      .settings = {},
      .warning = stiffFoldsWarning,
      .make = []() -> std::unique_ptr<Solver> {
        return std::make_unique<FilteredStepSolver>(RotationCorrection::Positions);
      }};
}

}  // namespace drape
