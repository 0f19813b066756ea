#include "ui/panels.hpp"
#include "ui/setting_widget.hpp"
#include "ui/widgets.hpp"

namespace drape {

void simulationPanel(PanelContext& context) {
  if (!beginSection(context, "Simulation", true)) {
    return;
  }
  settingsOfGroup(context, SettingGroup::Simulation);
  endSection();
}

}  // namespace drape
