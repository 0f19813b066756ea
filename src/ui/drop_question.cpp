#include "ui/dropped_files.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

#include <imgui.h>

namespace drape {
namespace {

/// One line for each file that can be the cloth; gives back the one that is chosen now.
std::size_t clothChoice(PanelContext& context, const DroppedFiles& files, std::size_t chosen) {
  const std::size_t count = files.meshes.size() + (files.scenes.empty() ? 0 : 1);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string word =
        i < files.meshes.size() ? shortName(files.meshes[i]) : "the cloth of " + shortName(files.scenes.back());
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::RadioButton(word.c_str(), i == chosen)) {
      chosen = i;
    }
    context.buttons["cloth." + std::to_string(i)] = lastItemRect();
    ImGui::PopID();
  }
  return chosen;
}

}  // namespace

bool dropQuestion(PanelContext& context, const UiRect& view, const DroppedFiles& files, std::size_t& cloth) {
  beginDialog(context, view, "drop", "Which one is the cloth?");
  cloth = clothChoice(context, files, cloth);
  ImGui::Spacing();
  ImGui::PushStyleColor(ImGuiCol_Text, palette().muted);
  ImGui::TextUnformatted(
      "The other meshes become bodies that the cloth meets.\nThey are read in the unit of the cloth and stay where "
      "their "
      "files put them.");
  ImGui::PopStyleColor();
  ImGui::Spacing();
  const float width = 130.0F * context.scale;
  const bool open = iconButton(context, "drop.open", Icon::None, "Open (Enter)", width, true) ||
                    ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
                    ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
  ImGui::SameLine();
  const bool cancel = iconButton(context, "drop.cancel", Icon::None, "Cancel (Esc)", width);
  if (open) {
    context.output.requests.emplace_back(OpenPartsRequest{partsWithCloth(files, cloth)});
  }
  endDialog();
  return !open && !cancel;
}

}  // namespace drape
