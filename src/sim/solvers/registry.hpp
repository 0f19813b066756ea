#pragma once

#include "sim/solvers/solver.hpp"

#include <array>

/// All solvers. Each has a function that describes it (SolverInfo), defined in the file of its name (`adaptive` in
/// auto.cpp), and an entry in the list. A new solver needs no other registration.
namespace drape::sim::solvers {

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

/// In display order.
inline constexpr std::array all{oneIteration, adaptive, chebyshev, pcg,     newton, verlet,     explicitEuler,
                                xpbd,         vbd,      kang,      desbrun, meyer,  localGlobal};

}  // namespace drape::sim::solvers
