#include "sim/solver.hpp"
#include "ui/panels.hpp"
#include "ui/setting_widget.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

namespace drape {

void simulationPanel(PanelContext& context) {
  if (!beginSection(context, "Simulation", true)) {
    return;
  }
  settingsOfGroup(context, SettingGroup::Simulation);
  valueRow(context, "Steps per second", formatNumber(1.0 / context.settings.step.timeStep));
  if (const SolverInfo* solver = findSolver(context.settings.solver.name)) {
    // The first sentence says what it is; the rest, what to expect of it.
    mutedText(solver->help.substr(0, solver->help.find(". ") + 1));
    explainItem(context, "solver.help", solver->help);
  }
  endSection();
}

}  // namespace drape
