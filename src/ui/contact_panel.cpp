#include "ui/panels.hpp"
#include "ui/setting_widget.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

namespace drape {
namespace {

/// One box to tick for each of the scene's bodies.
void bodyRows(PanelContext& context) {
  const std::vector<Body>& bodies = *context.snapshot.scene->bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    beginRow(context, bodies[i].name);
    bool on = i < context.snapshot.bodies.size() && context.snapshot.bodies[i].on;
    if (ImGui::Checkbox("##body", &on)) {
      context.output.commands.emplace_back(SwitchBodyCommand{static_cast<int>(i), on});
    }
    context.buttons["body." + bodies[i].name] = lastItemRect();
    ImGui::PopID();
  }
}

void reportRows(PanelContext& context) {
  const ContactReport& contact = context.snapshot.stepReport.contact;
  valueRow(context, "Contacts with bodies", formatCount(contact.bodyContacts));
  valueRow(context, "Cost of bodies", formatDuration(contact.bodySeconds));
  if (contact.overlaps > 0) {
    valueRow(context, "Triangles inside a body", formatCount(contact.overlaps), palette().warning);
    valueRow(context, "Deepest", formatQuantity(contact.deepestOverlap * 1e3, "mm"), palette().warning);
  }
  if (contact.squeezed > 0) {
    valueRow(context, "Vertices between bodies", formatCount(contact.squeezed), palette().warning);
  }
}

}  // namespace

void contactPanel(PanelContext& context) {
  const bool bodies = !context.snapshot.scene->bodies->empty();
  const bool self = context.settings.step.contact.self != SelfCollision::Off;
  if (!beginSection(context, "Contact", bodies || self)) {
    return;
  }
  settingsOfGroup(context, SettingGroup::Contact);
  if (self) {
    const ContactReport& contact = context.snapshot.stepReport.contact;
    valueRow(context, "Contacts with itself", formatCount(contact.selfContacts));
    valueRow(context, "Cost of these", formatDuration(contact.selfSeconds));
  }
  if (!bodies) {
    mutedText("There are no bodies in this scene.");
  } else {
    bodyRows(context);
    reportRows(context);
  }
  endSection();
}

}  // namespace drape
