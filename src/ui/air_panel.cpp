#include "ui/panels.hpp"
#include "ui/setting_widget.hpp"
#include "ui/widgets.hpp"

namespace drape {

void airPanel(PanelContext& context) {
  if (!beginSection(context, "Air", true)) {
    return;
  }
  settingsOfGroup(context, SettingGroup::Air);
  windDial(context);
  const StepParameters& step = context.settings.step;
  if (step.wind.norm() > 0.0 && step.drag == 0.0 && step.lift == 0.0) {
    mutedText("Wind has no effect while drag and lift are zero.", palette().warning);
  }
  endSection();
}

}  // namespace drape
