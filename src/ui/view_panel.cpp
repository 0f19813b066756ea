#include "ui/panels.hpp"
#include "ui/setting_widget.hpp"
#include "ui/widgets.hpp"

#include <array>

namespace drape {

void viewPanel(PanelContext& context) {
  if (!beginSection(context, "View", false)) {
    return;
  }
  settingsOfGroup(context, SettingGroup::View);
  struct ViewButton {
    const char* name;
    const char* word;
    UiAction action;
    const char* help;
  };
  static constexpr std::array<ViewButton, 4> buttons{{
      {"frame", "Frame", UiAction::FrameCloth, "Moves the camera so that the cloth fills the view (F)."},
      {"front", "Front", UiAction::ViewFront, "Looks from the front (1)."},
      {"right", "Right", UiAction::ViewRight, "Looks from the right (3)."},
      {"top", "Top", UiAction::ViewTop, "Looks from above (7)."},
  }};
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 3.0F * gap) / 4.0F;
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    if (i > 0) {
      ImGui::SameLine();
    }
    if (iconButton(context, buttons[i].name, Icon::None, buttons[i].word, width)) {
      context.output.requests.emplace_back(buttons[i].action);
    }
    explainItem(context, buttons[i].name, buttons[i].help);
  }
  endSection();
}

}  // namespace drape
