#include "ui/overlay_stack.hpp"
#include "ui/panels.hpp"
#include "ui/shortcuts.hpp"
#include "ui/widgets.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace drape::ui {
namespace {

/// A row of the help, in the language of the window.
struct HelpRow {
  std::string keys;
  std::string help;
};

constexpr std::array<std::pair<std::string_view, std::string_view>, 10> mouseTable{{
    {"Drag the cloth", "pull it"},
    {"Ctrl + drag", "pull it, and never turn the view"},
    {"Drag a body", "move it"},
    {"Drag beside it", "turn the view"},
    {"Middle or Shift + drag", "move the view"},
    {"Wheel", "zoom"},
    {"Double click", "centre the view on this point"},
    {"Right click the cloth", "mark a vertex and show its values"},
    {"Drop files", "open a scene, a garment, a garment with a body"},
    {"Click the line below", "show the solver and its cost"},
}};

/// Wide enough for all of them.
float widthOfKeys(const PanelContext& context, std::span<const HelpRow> rows) {
  float widest = 160.0F * context.scale;
  for (const HelpRow& row : rows) {
    widest = std::max(widest, ImGui::CalcTextSize(row.keys.c_str()).x);
  }
  return widest;
}

float widthOfTable(const PanelContext& context, std::span<const HelpRow> rows) {
  float widest = 0.0F;
  for (const HelpRow& row : rows) {
    widest = std::max(widest, ImGui::CalcTextSize(row.help.c_str()).x);
  }
  return widthOfKeys(context, rows) + ImGui::GetStyle().ItemSpacing.x + widest;
}

void helpTable(const PanelContext& context, const char* title, std::span<const HelpRow> rows) {
  mutedText(context.texts(title), palette().accent);
  if (ImGui::BeginTable(title, 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoHostExtendX)) {
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, widthOfKeys(context, rows));
    for (const HelpRow& row : rows) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(row.keys.c_str());
      ImGui::TableNextColumn();
      ImGui::PushStyleColor(ImGuiCol_Text, palette().muted);
      ImGui::TextUnformatted(row.help.c_str());
      ImGui::PopStyleColor();
    }
    ImGui::EndTable();
  }
}

std::vector<HelpRow> mouseHelp(const text::Catalogue& texts) {
  std::vector<HelpRow> rows;
  for (const auto& [keys, help] : mouseTable) {
    rows.push_back({texts(keys), texts(help)});
  }
  return rows;
}

std::vector<HelpRow> keyHelp(const text::Catalogue& texts) {
  std::vector<HelpRow> rows;
  for (const Shortcut& shortcut : shortcuts()) {
    if (!shortcut.keys.empty()) {
      rows.push_back({keysInWords(shortcut.keys, texts), texts(shortcut.help)});
    }
  }
  return rows;
}

constexpr const char* panelHelp =
    "In the panels: Ctrl+click types a value. A right click restores the scene's value, another one the default;\n"
    "a dot marks a value that differs from the scene's. \"Reset all\" restores every value.";

}  // namespace

bool helpOverlay(PanelContext& context, const UiRect& view) {
  beginDialog(context, view, "help", "Keys and mouse");
  // Side by side where the window is wide enough; below each other, the lists may have to scroll.
  const std::vector<HelpRow> mouse = mouseHelp(context.texts);
  const std::vector<HelpRow> keys = keyHelp(context.texts);
  constexpr float wide = 960.0F;  // at scale 1
  const float tables = widthOfTable(context, mouse) + widthOfTable(context, keys) + 66.0F * context.scale;
  const bool isWide = ImGui::GetIO().DisplaySize.x > std::max(wide * context.scale, tables);
  ImGui::BeginGroup();
  helpTable(context, "Mouse", mouse);
  ImGui::EndGroup();
  if (isWide) {
    ImGui::SameLine(0.0F, 30.0F * context.scale);
  } else {
    ImGui::Spacing();
  }
  ImGui::BeginGroup();
  helpTable(context, "Keys", keys);
  ImGui::EndGroup();
  ImGui::Spacing();
  ImGui::PushStyleColor(ImGuiCol_Text, palette().muted);
  ImGui::TextUnformatted(context.texts(panelHelp).c_str());
  ImGui::PopStyleColor();
  const bool closed = clickedBeside();
  endDialog();
  return !closed;
}

bool errorNotice(PanelContext& context, OverlayStack& stack) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float button =
      ImGui::CalcTextSize(context.texts("Close").c_str()).x + 2.0F * style.FramePadding.x + style.ItemSpacing.x;
  const std::string text = context.texts(context.stats.error);
  stack.begin("error");
  const float widest = stack.textWidth() - button - style.ScrollbarSize;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, widest);
  // A very long message scrolls.
  ImGui::BeginChild("text", {size.x + style.ScrollbarSize, std::min(size.y, stack.heightBelow())});
  ImGui::PushStyleColor(ImGuiCol_Text, palette().error);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + widest);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::EndChild();
  ImGui::SameLine();
  const bool closed = ImGui::SmallButton(labelOf(context, "Close", "close").c_str());
  context.buttons["button.close"] = lastItemRect();
  stack.end();
  return !closed;
}

void loadingNotice(PanelContext& context, OverlayStack& stack) {
  const UiStats& stats = context.stats;
  stack.begin("loading");
  ImGui::TextUnformatted(context.texts(stats.loading).c_str());
  if (stats.loadingShare >= 0.0) {
    stack.progressBar(stats.loadingShare);
  }
  stack.end();
}

void dressingNotice(PanelContext& context, OverlayStack& stack) {
  const DressingProgress& progress = *context.stats.dressing;
  stack.begin("dressing");
  ImGui::TextUnformatted(context.texts(progress.words).c_str());
  stack.progressBar(progress.share);
  if (iconButton(context, "cancel_dressing", Icon::None, "Cancel (Esc)",
                 widthOfButton(context, "Cancel (Esc)", 8.0F * ImGui::GetFontSize()))) {
    context.output.requests.emplace_back(UiAction::CancelDressing);
  }
  stack.end();
}

void dragHint(const PanelContext& context, OverlayStack& stack) {
  stack.begin("drag", OverlayStack::Mouse::LetThrough);
  ImGui::TextUnformatted(context.texts("Drag the cloth. F1: help").c_str());
  stack.end();
}

bool replaceQuestion(PanelContext& context, const UiRect& view, const std::string& file) {
  beginDialog(context, view, "replace", "Replace the file?");
  ImGui::TextUnformatted(context.texts("{} exists already.", file).c_str());
  ImGui::Spacing();
  const bool replace = iconButton(context, "replace", Icon::None, "Replace (Enter)",
                                  widthOfButton(context, "Replace (Enter)", 150.0F * context.scale), true) ||
                       ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
                       ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
  ImGui::SameLine();
  const bool keep = iconButton(context, "keep", Icon::None, "Keep (Esc)",
                               widthOfButton(context, "Keep (Esc)", 130.0F * context.scale)) ||
                    clickedBeside();
  if (replace) {
    context.output.requests.emplace_back(SaveSceneRequest{file, true});
  }
  endDialog();
  return !replace && !keep;
}

text::Sentence whatQuittingLoses(const std::optional<ExportProgress>& exporting, bool hasChanges) {
  if (!exporting) {
    return text::Sentence(hasChanges ? "Your changes to this scene would be lost." : "Nothing would be lost.");
  }
  return text::Sentence(
      hasChanges ? "The export of {} and your changes to this scene would be lost." : "The export of {} would be lost.",
      exporting->file);
}

bool quitQuestion(PanelContext& context, const UiRect& view, bool hasChanges) {
  beginDialog(context, view, "quit", "Quit?");
  ImGui::TextUnformatted(context.texts(whatQuittingLoses(context.stats.exporting, hasChanges)).c_str());
  ImGui::Spacing();
  const bool quit = iconButton(context, "quit", Icon::None, "Quit (Enter)",
                               widthOfButton(context, "Quit (Enter)", 130.0F * context.scale), true) ||
                    ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
                    ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
  ImGui::SameLine();
  const bool stay = iconButton(context, "stay", Icon::None, "Stay (Esc)",
                               widthOfButton(context, "Stay (Esc)", 130.0F * context.scale)) ||
                    clickedBeside();
  if (quit) {
    context.output.requests.emplace_back(UiAction::QuitAndLoseChanges);
  }
  endDialog();
  return !quit && !stay;
}

}  // namespace drape::ui
