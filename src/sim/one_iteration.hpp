#pragma once

#include "sim/solver.hpp"

#include <memory>

namespace drape {

/// The one-iteration implicit mass-spring step: backward Euler, W dv = h f~ with W = M - h^2 J, solved by `sweeps`
/// block-Jacobi sweeps from p = h D^-1 f~ (eqs. 5-14 and 16; one sweep is eq. 11, the paper's method). The number of
/// sweeps must be odd: with an even number the amplification of the stiffest modes can exceed one.
[[nodiscard]] std::unique_ptr<Solver> makeOneIterationSolver();

}  // namespace drape
