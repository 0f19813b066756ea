#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace drape {

void headPanel(PanelContext& context) {
  const Snapshot& snapshot = context.snapshot;
  const SceneDescription& scene = snapshot.scene->description;
  ImGui::PushFont(context.fonts.title);
  mutedText(scene.title.empty() ? scene.name : scene.title, palette().text);
  ImGui::PopFont();
  ImGui::Dummy({0.0F, 2.0F * context.scale});

  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = ImGui::GetContentRegionAvail().x;
  const float wide = (width - 2.0F * gap) * 0.4F;
  const float narrow = (width - 2.0F * gap) * 0.3F;
  if (iconButton(context, "play", snapshot.paused ? Icon::Play : Icon::Pause, snapshot.paused ? "Play" : "Pause", wide,
                 true)) {
    context.output.commands.emplace_back(PauseCommand{!snapshot.paused});
  }
  explainItem(context, "button.play", "Starts and stops the clock (space).");
  ImGui::SameLine();
  if (iconButton(context, "step", Icon::Step, "Step", narrow)) {
    context.output.commands.emplace_back(SingleStepCommand{});
  }
  explainItem(context, "button.step", "Advances by one time step and pauses (full stop).");
  ImGui::SameLine();
  if (iconButton(context, "reset", Icon::Reset, "Reset", narrow)) {
    context.output.commands.emplace_back(ResetCommand{});
  }
  explainItem(context, "button.reset", "Back to the scene's start. Settings and pins stay (R).");
}

}  // namespace drape
