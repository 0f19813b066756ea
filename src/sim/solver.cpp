#include "sim/solver.hpp"

#include "sim/solvers/registry.hpp"

#include <algorithm>

namespace drape {

StepReport Solver::steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                         ClothState& state) {
  StepReport total;
  for (int i = 0; i < count; ++i) {
    total.add(step(model, parameters, inputs, state));
  }
  return total;
}

std::span<const SolverInfo> solverTable() {
  static const std::vector<SolverInfo> table = [] {
    std::vector<SolverInfo> infos;
    for (const auto describe : solvers::all) {
      infos.push_back(describe());
    }
    return infos;
  }();
  return table;
}

const SolverInfo* findSolver(std::string_view name) {
  const auto table = solverTable();
  const auto found = std::find_if(table.begin(), table.end(), [&](const SolverInfo& s) { return s.name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace drape
