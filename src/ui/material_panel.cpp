#include "ui/panels.hpp"
#include "ui/setting_widget.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

namespace drape {

void materialPanel(PanelContext& context) {
  if (!beginSection(context, "Material", true)) {
    return;
  }
  settingsOfGroup(context, SettingGroup::Material);
  const ClothModel& model = *context.snapshot.model;
  const double mass = model.totalMass();
  const double area = model.restArea();
  if (context.settings.material.massGivenAs == "density") {
    valueRow(context, "Mass of the cloth", formatQuantity(mass, "kg"));
  } else if (area > 0.0) {
    valueRow(context, "Density", formatQuantity(mass / area, "kg/m\u00B2"));
  }
  endSection();
}

}  // namespace drape
