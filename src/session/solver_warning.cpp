#include "session/solver_warning.hpp"

#include "messages/error.hpp"
#include "messages/sim_error_text.hpp"
#include "messages/solver_warning_text.hpp"
#include "session/ghost.hpp"
#include "sim/solvers/solver.hpp"

#include <utility>

namespace drape::session {
namespace {

text::Sentence warningOf(const std::string& name, const sim::ClothModel& model, const sim::StepParameters& parameters) {
  const sim::SolverInfo* solver = sim::findSolver(name);
  if (solver == nullptr || solver->warning == nullptr) {
    return {};
  }
  const std::optional<sim::SolverWarning> warning = solver->warning(model, parameters);
  return warning ? messages::inWords(*warning) : text::Sentence();
}

}  // namespace

text::Sentence solverWarning(const settings::Settings& settings, const sim::ClothModel& model) {
  return warningOf(settings.solver.name, model, settings.step);
}

text::Sentence ghostWarning(const settings::Settings& settings, const sim::ClothModel& model) {
  return warningOf(settings.ghost.solver, model, ghostParameters(settings));
}

void requireSolversForMaterial(const settings::Settings& settings) {
  if (!settings::usesFabric(settings)) {
    return;
  }
  for (const auto& [key, name] :
       {std::pair("solver", settings.solver.name), std::pair("ghost.solver", settings.ghost.solver)}) {
    const sim::SolverInfo* solver = sim::findSolver(name);
    if (solver != nullptr && !solver->takesFabric) {
      throw messages::InputError(messages::takesSpringsOnly(key, name).english());
    }
  }
}

}  // namespace drape::session
