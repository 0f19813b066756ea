#include "sim/solver.hpp"

#include "sim/one_iteration.hpp"

#include <algorithm>
#include <array>

namespace drape {

std::span<const SolverInfo> solverTable() {
  static constexpr std::array solvers{
      SolverInfo{
          "one_iteration", "One iteration (implicit)",
          "Backward Euler with one block-Jacobi sweep a step and a force derivative that is stabilised where "
          "springs are compressed. Cheap and calm at large steps; stiff cloth turns slack and sluggish, and very "
          "fine stiff meshes can still blow up.",
          makeOneIterationSolver},
  };
  return solvers;
}

const SolverInfo* findSolver(std::string_view name) {
  const auto table = solverTable();
  const auto found = std::find_if(table.begin(), table.end(), [&](const SolverInfo& s) { return s.name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace drape
