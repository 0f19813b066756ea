#include "session/ghost.hpp"
#include "session/solver_warning.hpp"
#include "ui/panels.hpp"
#include "ui/setting_widget.hpp"
#include "ui/solver_facts.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

namespace drape {

void ghostPanel(PanelContext& context) {
  if (!beginSection(context, "Ghost", context.settings.ghost.solver != "off")) {
    return;
  }
  settingsOfGroup(context, SettingGroup::Ghost);
  const SolverInfo* solver = findSolver(context.settings.ghost.solver);
  if (solver == nullptr) {
    mutedText("A second cloth, in green, moved by another solver. Choose a solver to compare.");
    endSection();
    return;
  }
  if (const std::optional<GhostStatus>& ghost = context.snapshot.ghost) {
    valueRow(context, "Mean distance", formatQuantity(ghost->meanDistance * 1e3, "mm"), palette().ghost);
    valueRow(context, "Step", formatDuration(ghost->stepSeconds));
    solverRows(context, *solver, ghostParameters(context.settings), ghost->stepReport);
  }
  solverHelp(context, *solver);
  steadyText(context, "ghost.warning", ghostWarning(context.settings, *context.snapshot.model), palette().warning);
  endSection();
}

}  // namespace drape
