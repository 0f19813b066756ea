#include "ui/panels.hpp"
#include "ui/widgets.hpp"

#include <algorithm>
#include <array>

namespace drape {
namespace {

constexpr ImGuiWindowFlags overlayFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize;

struct HelpRow {
  const char* keys;
  const char* what;
};

constexpr std::array<HelpRow, 8> mouseHelp{{
    {"Drag the cloth", "pull it"},
    {"Ctrl + drag", "pull it, and never turn the view"},
    {"Drag a body", "move it"},
    {"Drag beside it", "turn the view"},
    {"Middle or Shift + drag", "move the view"},
    {"Wheel", "nearer and farther"},
    {"Double click", "look at that point"},
    {"Drop a file", "open a scene or a mesh"},
}};

constexpr std::array<HelpRow, 11> keyHelp{{
    {"Space", "play and pause"},
    {".", "one step"},
    {"R", "back to the start"},
    {"P", "pin what is held, or let it go"},
    {"F", "frame the cloth"},
    {"1   3   7", "front, right, top"},
    {"W", "wireframe"},
    {"H", "hide and show the panels"},
    {"F12", "save a picture"},
    {"F1   ?", "this list"},
    {"Esc", "let go, close, quit"},
}};

template <std::size_t size>
void helpTable(float scale, const char* title, const std::array<HelpRow, size>& rows) {
  mutedText(title, palette().accent);
  if (ImGui::BeginTable(title, 2, ImGuiTableFlags_SizingFixedFit)) {
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, 165.0F * scale);
    for (const HelpRow& row : rows) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(row.keys);
      ImGui::TableNextColumn();
      ImGui::PushStyleColor(ImGuiCol_Text, palette().muted);
      ImGui::TextUnformatted(row.what);
      ImGui::PopStyleColor();
    }
    ImGui::EndTable();
  }
}

void pushOverlayStyle(float padding) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, padding * 0.5F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padding, padding));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.13F, 0.145F, 0.18F, 0.97F));
}

void popOverlayStyle() {
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

void rememberWindow(PanelContext& context, const char* name) {
  const ImVec2 at = ImGui::GetWindowPos();
  const ImVec2 size = ImGui::GetWindowSize();
  context.buttons[name] = {at.x, at.y, size.x, size.y};
}

}  // namespace

bool helpOverlay(PanelContext& context, const UiRect& view) {
  const float padding = 18.0F * context.scale;
  ImGui::SetNextWindowPos(
      {static_cast<float>(view.x + view.width * 0.5), static_cast<float>(view.y + view.height * 0.5)}, ImGuiCond_Always,
      {0.5F, 0.5F});
  pushOverlayStyle(padding);
  ImGui::Begin("Help", nullptr, overlayFlags);
  rememberWindow(context, "overlay.help");
  ImGui::PushFont(context.fonts.title);
  ImGui::TextUnformatted("Keys and mouse");
  ImGui::PopFont();
  ImGui::Spacing();
  helpTable(context.scale, "Mouse", mouseHelp);
  ImGui::Spacing();
  helpTable(context.scale, "Keys", keyHelp);
  ImGui::Spacing();
  mutedText("In the panels: Ctrl+click types a value,\na right click goes back to the default.");
  const bool clickedBeside =
      ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsWindowHovered(ImGuiHoveredFlags_AnyWindow);
  ImGui::End();
  popOverlayStyle();
  return !clickedBeside;
}

bool errorNotice(PanelContext& context, const UiRect& view) {
  const float margin = 12.0F * context.scale;
  const float width = std::min(static_cast<float>(view.width) - 2.0F * margin, 44.0F * ImGui::GetFontSize());
  ImGui::SetNextWindowPos({static_cast<float>(view.x + view.width * 0.5), static_cast<float>(view.y) + margin},
                          ImGuiCond_Always, {0.5F, 0.0F});
  pushOverlayStyle(margin);
  ImGui::Begin("Notice", nullptr, overlayFlags);
  rememberWindow(context, "overlay.error");
  const float button = ImGui::CalcTextSize("Close").x + 2.0F * ImGui::GetStyle().FramePadding.x;
  ImGui::PushTextWrapPos(width - button - margin);
  ImGui::PushStyleColor(ImGuiCol_Text, palette().error);
  ImGui::TextUnformatted(context.stats.error.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::SameLine(0.0F, margin);
  const bool closed = ImGui::SmallButton("Close");
  context.buttons["button.close"] = lastItemRect();
  ImGui::End();
  popOverlayStyle();
  return !closed;
}

}  // namespace drape
