#include "sim/solvers/filtered_step.hpp"
#include "sim/solvers/registry.hpp"
#include "sim/stability.hpp"

namespace drape {

/// Meyer, Debunne, Desbrun and Barr (2001): the constant filter of `desbrun`, with the rotation that it brings in taken
/// back from the velocities (filtered_step.hpp has the equations).
///
/// What could be established of the paper: it splits a spring's force k (x_j - x_i) - k l0 d into a linear part, taken
/// implicitly with the same constant matrix, and a part of constant size that only turns, taken as it is at the start
/// of the step, whose error is made up for by a correction of the torque. Filtering the whole force and h times its
/// linear part's change is the same step. Not established: whether external forces pass through the matrix (a patent
/// of the same authors, US 6,573,897, filed in 2000, keeps them out, and corrects locations, as in 1999), and how the
/// corrected locations reach the velocities. So what sets this solver apart from `desbrun` here is one decision of
/// ours: the correction changes the velocities, and through them the positions, which keeps the angular momentum of
/// cloth without pins to rounding. As there, overlong springs are not shortened afterwards.
SolverInfo solvers::meyer() {
  return {
      .name = "meyer",
      .title = "Meyer constant filter",
      .help =
          "As desbrun, a constant matrix filters the spring forces, but the rotation that it brings in is taken back "
          "from the velocities: cloth that nothing holds keeps its momentum and its spin exactly. Same cost, same "
          "set-up whenever time step, stiffness, damping, mass or pins change, same stiff folds; what is pinned "
          "moves as with desbrun to the last digit.",
      .source =
          "Meyer, Debunne, Desbrun and Barr (2001), Interactive animation of cloth-like objects in virtual reality",
      .backwardEuler = false,
      .settings = {},
      .warning = stiffFoldsWarning,
      .make = []() -> std::unique_ptr<Solver> {
        return std::make_unique<FilteredStepSolver>(RotationCorrection::Velocities);
      }};
}

}  // namespace drape
