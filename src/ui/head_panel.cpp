#include "ui/panels.hpp"
#include "ui/scene_changes.hpp"
#include "ui/widgets.hpp"

#include <string>

namespace drape::ui {
namespace {

std::string titleOf(const PanelContext& context, const std::string& title, const std::string& name) {
  return title.empty() ? name : context.texts(title);
}

/// The list of built-in scenes.
void otherScenes(PanelContext& context) {
  for (const scene::SceneInfo& scene : context.memory.scenes) {
    ImGui::PushID(scene.name.c_str());
    if (ImGui::Selectable((titleOf(context, scene.title, scene.name) + "###scene").c_str(),
                          scene.name == context.snapshot.scene->description.name)) {
      context.output.requests.emplace_back(OpenSceneRequest{scene.name});
    }
    const UiRect row = lastItemRect();
    context.buttons["scene.choice=" + scene.name] = row;
    if (ImGui::IsItemHovered() && hoveredLongEnough(context, "scene.choice=" + scene.name)) {
      beginExplanation(context, &row);
      ImGui::TextWrapped("%s", context.texts(scene.help).c_str());
      endExplanation();
    }
    ImGui::PopID();
  }
}

/// The title of the scene, which opens the list of the others.
void sceneChoice(PanelContext& context) {
  const scene::SceneDescription& running = context.snapshot.scene->description;
  ImGui::PushFont(context.fonts.title);
  ImGui::PushStyleColor(ImGuiCol_FrameBg, ImVec4(0.0F, 0.0F, 0.0F, 0.0F));
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.0F, 0.0F, 0.0F, 0.0F));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  const bool open =
      ImGui::BeginCombo("##scene", titleOf(context, running.title, running.name).c_str(), ImGuiComboFlags_HeightLarge);
  ImGui::PopStyleColor(2);
  if (open) {
    ImGui::PushFont(context.fonts.regular);
    otherScenes(context);
    ImGui::PopFont();
    ImGui::EndCombo();
  }
  ImGui::PopFont();
  if (!open) {
    context.buttons["scene.choice"] = lastItemRect();
    explainItem(context, "scene.choice", text::Sentence("{} Click for other scenes.", text::Sentence(running.help)));
  }
}

/// Restores the scene's own values; highlighted while something differs.
void resetAllButton(PanelContext& context, float width) {
  const bool differs = differsFromScene(context.snapshot, context.settings);
  ImGui::BeginDisabled(!differs && context.snapshot.step == 0);
  if (iconButton(context, "reset_all", Icon::None, "Reset all", width)) {
    context.output.requests.emplace_back(UiAction::ResetAll);
  }
  ImGui::EndDisabled();
  explainItem(context, "button.reset_all",
              "Returns to the start of the scene and restores its settings, pins and bodies.");
}

}  // namespace

void headPanel(PanelContext& context) {
  const session::Snapshot& snapshot = context.snapshot;
  sceneChoice(context);
  ImGui::Dummy({0.0F, 2.0F * context.scale});

  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = ImGui::GetContentRegionAvail().x;
  const bool oneRow = width > 300.0F * context.scale;
  const float share = width - (oneRow ? 3.0F : 1.0F) * gap;
  const float wide = share * (oneRow ? 0.27F : 0.5F);
  const float narrow = share * (oneRow ? 0.235F : 0.5F);
  if (iconButton(context, "play", snapshot.paused ? Icon::Play : Icon::Pause, snapshot.paused ? "Play" : "Pause", wide,
                 true)) {
    context.output.commands.emplace_back(session::PauseCommand{!snapshot.paused});
  }
  explainItem(context, "button.play", "Starts and pauses the simulation (space).");
  ImGui::SameLine();
  if (iconButton(context, "step", Icon::Step, "Step", narrow)) {
    context.output.commands.emplace_back(session::SingleStepCommand{});
  }
  explainItem(context, "button.step", "Advances by one time step and pauses (full stop).");
  if (oneRow) {
    ImGui::SameLine();
  }
  if (iconButton(context, "reset", Icon::Reset, "Reset", narrow)) {
    context.output.commands.emplace_back(session::ResetCommand{});
  }
  explainItem(context, "button.reset", "Returns to the start of the scene. Keeps settings and pins (R).");
  ImGui::SameLine();
  resetAllButton(context, ImGui::GetContentRegionAvail().x);
}

}  // namespace drape::ui
