#include "sim/solvers/common_warnings.hpp"
#include "sim/solvers/filtered_step.hpp"
#include "sim/solvers/registry.hpp"

namespace drape::sim {

/// Meyer, Debunne, Desbrun and Barr (2001): the constant filter of `desbrun`, with the rotation that it adds removed
/// from the velocities (filtered_step.hpp has the equations).
///
/// The paper splits a spring's force k (x_j - x_i) - k l0 d into a linear part and a part of constant size. The linear
/// part is implicit, with the same constant matrix. The other part is explicit, and a correction of the torque
/// compensates its error. Filtering the whole force and h times the change of its linear part is the same step. We
/// could not establish whether external forces pass through the matrix, and how the corrected positions change the
/// velocities. (A patent of the same authors, US 6,573,897, filed in 2000, does not filter external forces and corrects
/// positions, as in 1999.) So this solver differs from `desbrun` by a decision of ours: the correction changes the
/// velocities, and through them the positions. This conserves the angular momentum of free cloth to rounding. As in
/// `desbrun`, overlong springs are not shortened afterwards.
SolverInfo solvers::meyer() {
  return {
      .name = "meyer",
      .title = "Meyer constant filter",
      .help =
          "Like desbrun, but the rotation that the filter adds is removed from the velocities. So free cloth conserves "
          "its linear and angular momentum. The cost, the setup after changes of the time step, stiffness, damping, "
          "mass or pins, and the stiff folds are the same. Cloth with pins moves exactly as with desbrun.",
      .source =
          "Meyer, Debunne, Desbrun and Barr (2001), Interactive animation of cloth-like objects in virtual reality",
      .backwardEuler = false,
      .settings = {},
      .warning = stiffFoldsWarning,
      .make = []() -> std::unique_ptr<Solver> {
        return std::make_unique<FilteredStepSolver>(RotationCorrection::Velocities);
      }};
}

}  // namespace drape::sim
