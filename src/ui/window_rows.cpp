#include "locale/language.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace drape::ui {

void themeRow(PanelContext& context) {
  beginRow(context, "Panels");
  const float gap = std::round(2.0F * context.scale);
  const auto count = static_cast<float>(themes().size());
  const float width = (ImGui::CalcItemWidth() - gap * (count - 1.0F)) / count;
  for (const ThemeInfo& theme : themes()) {
    const bool chosen = theme.theme == context.theme;
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? palette().accentFill : palette().field);
    if (ImGui::Button(labelOf(context, theme.title, theme.name).c_str(), {width, ImGui::GetFrameHeight()}) && !chosen) {
      context.output.requests.emplace_back(ThemeRequest{theme.theme});
    }
    ImGui::PopStyleColor();
    const std::string name = "theme=" + std::string(theme.name);
    context.buttons[name] = lastItemRect();
    explainItem(context, name, "The colours of the panels. They are kept for the next start.");
    if (&theme != &themes().back()) {
      ImGui::SameLine(0.0F, gap);
    }
  }
}

void languageRow(PanelContext& context) {
  beginRow(context, "Language");
  const std::span<const locale::Language> languages = locale::languages();
  std::vector<Segment> titles;
  std::size_t chosen = languages.size();  // a file of the user is none of them
  for (const locale::Language& language : languages) {
    chosen = language.name == context.language ? titles.size() : chosen;
    titles.push_back({language.name, language.title, true});
  }
  const std::size_t next = segments(context, "language", titles, chosen);
  if (next != chosen) {
    context.output.requests.emplace_back(LanguageRequest{languages[next].name});
  }
}

void cameraRows(PanelContext& context) {
  static constexpr std::array<Segment, 2> projections{
      {{"perspective", "Perspective"}, {"orthographic", "Orthographic"}}};
  const CameraStatus& camera = context.stats.camera;
  const auto request = [&](UiAction action) { context.output.requests.emplace_back(action); };
  beginRow(context, "Projection");
  const std::size_t chosen = camera.isOrthographic ? 1 : 0;
  if (segments(context, "projection", projections, chosen) != chosen) {
    request(UiAction::ToggleProjection);
  }
  beginRow(context, "Turntable");
  bool turns = camera.turns;
  if (ImGui::Checkbox("##turntable", &turns)) {
    request(UiAction::ToggleTurntable);
  }
  context.buttons["turntable"] = lastItemRect();
  explainItem(context, "turntable", "The camera turns around the cloth, once in 12 seconds (T).");
  beginRow(context, "Kept views");
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width =
      (ImGui::CalcItemWidth() - gap * static_cast<float>(keptViewCount - 1)) / static_cast<float>(keptViewCount);
  for (std::size_t i = 0; i < keptViewCount; ++i) {
    const int slot = static_cast<int>(i);
    const auto recall = static_cast<UiAction>(static_cast<int>(UiAction::RecallView1) + slot);
    const auto keep = static_cast<UiAction>(static_cast<int>(UiAction::KeepView1) + slot);
    const std::string number = std::to_string(slot + 1);
    const bool isKept = camera.hasView[i];
    ImGui::PushStyleColor(ImGuiCol_Button, isKept ? palette().accentFill : palette().field);
    if (ImGui::Button((number + "##view").c_str(), {width, ImGui::GetFrameHeight()})) {
      request(isKept ? recall : keep);
    }
    ImGui::PopStyleColor();
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
      request(keep);
    }
    context.buttons["view=" + number] = lastItemRect();
    explainItem(context, "view=" + number,
                isKept ? "Returns to this view (F5 to F8). A right click keeps the present view here."
                       : "Keeps the present view for this scene (Ctrl+F5 to Ctrl+F8).");
    if (i + 1 < keptViewCount) {
      ImGui::SameLine(0.0F, gap);
    }
  }
}

void recentFilesRow(PanelContext& context) {
  if (context.stats.recentFiles.empty()) {
    return;
  }
  beginRow(context, "Recent files");
  if (ImGui::BeginCombo("##recent", context.texts("choose").c_str(), ImGuiComboFlags_HeightLarge)) {
    for (const std::string& file : context.stats.recentFiles) {
      ImGui::PushID(file.c_str());
      if (ImGui::Selectable(std::filesystem::path(file).filename().c_str())) {
        context.output.requests.emplace_back(OpenSceneRequest{file});
      }
      context.buttons["recent=" + file] = lastItemRect();
      explainItem(context, "recent=" + file, text::Sentence::verbatim(file));
      ImGui::PopID();
    }
    ImGui::EndCombo();
  } else {
    context.buttons["recent"] = lastItemRect();
  }
}

}  // namespace drape::ui
