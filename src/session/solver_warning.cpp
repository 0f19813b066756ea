#include "session/solver_warning.hpp"

#include "messages/solver_warning_text.hpp"
#include "session/ghost.hpp"
#include "sim/solvers/solver.hpp"

namespace drape {
namespace {

std::string warningOf(const std::string& name, const ClothModel& model, const StepParameters& parameters) {
  const SolverInfo* solver = findSolver(name);
  if (solver == nullptr || solver->warning == nullptr) {
    return {};
  }
  const std::optional<SolverWarning> warning = solver->warning(model, parameters);
  return warning ? inWords(*warning) : std::string();
}

}  // namespace

std::string solverWarning(const Settings& settings, const ClothModel& model) {
  return warningOf(settings.solver.name, model, settings.step);
}

std::string ghostWarning(const Settings& settings, const ClothModel& model) {
  return warningOf(settings.ghost.solver, model, ghostParameters(settings));
}

}  // namespace drape
