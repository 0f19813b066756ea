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
    mutedText(solver->help);
  }
  endSection();
}

}  // namespace drape
