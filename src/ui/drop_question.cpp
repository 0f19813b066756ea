#include "ui/dropped_files.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace drape::ui {
namespace {

constexpr const char* explanation =
    "The other meshes become bodies that the cloth meets.\n"
    "Open reads them in the unit of the cloth and leaves all where the files put it.\n"
    "Dress puts the cloth on the body and removes all intersections.";

/// The names of what can be the cloth.
std::vector<std::string> namesOfChoices(const PanelContext& context, const DroppedFiles& files) {
  std::vector<std::string> choices = distinctNames(files.meshes);
  if (!files.scenes.empty()) {
    choices.push_back(context.texts("the cloth of {}", shortName(files.scenes.back())));
  }
  return choices;
}

/// One line for each choice. Returns the index of the chosen one.
std::size_t radioButtons(PanelContext& context, const std::vector<std::string>& choices, std::size_t chosen,
                         float textWidth) {
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1.5F * context.scale);
  ImGui::PushStyleColor(ImGuiCol_Border, palette().muted);
  for (std::size_t i = 0; i < choices.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::RadioButton((fitted(choices[i], textWidth) + "###choice").c_str(), i == chosen)) {
      chosen = i;
    }
    context.buttons["cloth." + std::to_string(i)] = lastItemRect();
    ImGui::PopID();
  }
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  return chosen;
}

/// The choices, in a box that scrolls when they do not all fit into the picture.
std::size_t clothChoice(PanelContext& context, const UiRect& view, const std::vector<std::string>& choices,
                        std::size_t chosen) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float row = ImGui::GetFrameHeightWithSpacing();
  const float button = ImGui::GetFrameHeight() + style.ItemInnerSpacing.x;
  float textWidth = 0.0F;
  for (const std::string& choice : choices) {
    textWidth = std::max(textWidth, ImGui::CalcTextSize(choice.c_str()).x);
  }
  const float widest = static_cast<float>(view.width) - button - style.ScrollbarSize - 6.0F * style.WindowPadding.x;
  textWidth = std::min(textWidth, std::max(widest, 12.0F * ImGui::GetFontSize())) + 1.0F;
  const float room = std::max(2.0F * row, static_cast<float>(view.height) - 9.0F * row);
  const float height = std::min(room, row * static_cast<float>(choices.size()));
  // As wide as the text below, so that the scroll bar is at the edge of the dialog.
  const float below =
      std::min(ImGui::CalcTextSize(context.texts(explanation).c_str()).x, ImGui::GetIO().DisplaySize.x - 3.0F * button);
  ImGui::BeginChild("choices", {std::max(below, textWidth + button + style.ScrollbarSize), height});
  chosen = radioButtons(context, choices, chosen, textWidth);
  ImGui::EndChild();
  return chosen;
}

}  // namespace

bool dropQuestion(PanelContext& context, const UiRect& view, const DroppedFiles& files, std::size_t& cloth) {
  beginDialog(context, view, "drop", "Which one is the cloth?");
  cloth = clothChoice(context, view, namesOfChoices(context, files), cloth);
  ImGui::Spacing();
  ImGui::PushStyleColor(ImGuiCol_Text, palette().muted);
  ImGui::TextUnformatted(context.texts(explanation).c_str());
  ImGui::PopStyleColor();
  ImGui::Spacing();
  float width = 130.0F * context.scale;
  for (const char* word : {"Open (Enter)", "Dress", "Cancel (Esc)"}) {
    width = widthOfButton(context, word, width);
  }
  const bool open = iconButton(context, "drop.open", Icon::None, "Open (Enter)", width, true) ||
                    ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
                    ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
  ImGui::SameLine();
  const bool dress = iconButton(context, "drop.dress", Icon::None, "Dress", width);
  bool alone = false;
  if (!files.alone.empty()) {
    ImGui::SameLine();
    alone =
        iconButton(context, "drop.alone", Icon::None,
                   text::Sentence::verbatim(fitted(context.texts("Only {}", shortName(files.alone)), width)), width);
  }
  ImGui::SameLine();
  const bool cancel = iconButton(context, "drop.cancel", Icon::None, "Cancel (Esc)", width);
  if (open || dress) {
    scene::SceneParts parts = partsWithCloth(files, cloth);
    parts.dressed = dress;
    context.output.requests.emplace_back(OpenPartsRequest{std::move(parts)});
  } else if (alone) {
    context.output.requests.emplace_back(OpenPartsRequest{{.scene = files.alone}});
  }
  endDialog();
  return !open && !dress && !alone && !cancel;
}

}  // namespace drape::ui
