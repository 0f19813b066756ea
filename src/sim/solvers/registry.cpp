#include "sim/solvers/registry.hpp"

#include <algorithm>
#include <vector>

namespace drape::sim {

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

}  // namespace drape::sim
