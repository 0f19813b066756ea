#pragma once

#include "sim/solver.hpp"

#include <array>

/// Every solver: a function that describes it, defined in the file of its name, and its place in the list. Nothing else
/// has to know a new one.
namespace drape::solvers {

SolverInfo oneIteration();
SolverInfo chebyshev();
SolverInfo pcg();
SolverInfo newton();
SolverInfo verlet();
SolverInfo explicitEuler();
SolverInfo xpbd();
SolverInfo vbd();
SolverInfo kang();
SolverInfo desbrun();
SolverInfo meyer();
SolverInfo localGlobal();
SolverInfo adaptive();

/// In the order in which they are shown; the first is the default.
inline constexpr std::array all{oneIteration, adaptive, chebyshev, pcg,     newton, verlet,     explicitEuler,
                                xpbd,         vbd,      kang,      desbrun, meyer,  localGlobal};

}  // namespace drape::solvers
