#include "session/solver_warning.hpp"
#include "ui/panels.hpp"
#include "ui/setting_widget.hpp"
#include "ui/solver_facts.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

namespace drape {

void advancedPanel(PanelContext& context) {
  if (!beginSection(context, "Advanced", false)) {
    return;
  }
  settingsOfGroup(context, SettingGroup::Advanced);
  valueRow(context, "Steps per second", formatNumber(1.0 / context.settings.step.timeStep));
  if (const SolverInfo* solver = findSolver(context.settings.solver.name)) {
    solverRows(context, *solver, context.settings.step, context.snapshot.stepReport);
    solverHelp(context, *solver);
  }
  steadyText(context, "solver.warning", solverWarning(context.settings, *context.snapshot.model), palette().warning);
  endSection();
}

}  // namespace drape
