#include "text/number_text.hpp"
#include "ui/button_row.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

#include <fmt/core.h>

#include <array>
#include <string>

namespace drape::ui {
namespace {

constexpr const char* rectangleHelp = "Drag a rectangle over vertices, or click one. Shift adds, Ctrl removes.";
constexpr const char* borderHelp = "Click near an open border. Shift adds, Ctrl removes.";

void request(PanelContext& context, UiAction action) {
  context.output.requests.emplace_back(action);
}

/// The dots on the selected vertices, and the rectangle while it is dragged.
void drawSelection(const SelectionView& selection, const UiRect& view, float scale) {
  ImDrawList& canvas = *ImGui::GetBackgroundDrawList();
  const ImVec2 low{static_cast<float>(view.x), static_cast<float>(view.y)};
  canvas.PushClipRect(low, {low.x + static_cast<float>(view.width), low.y + static_cast<float>(view.height)});
  const ImU32 colour = ImGui::GetColorU32(palette().warning);
  const float half = 2.0F * scale;
  for (const Vec2& point : selection.points) {
    const ImVec2 at{static_cast<float>(point.x()), static_cast<float>(point.y())};
    canvas.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, colour);
  }
  if (const auto& rectangle = selection.rectangle) {
    const ImVec2 from{static_cast<float>(rectangle->x), static_cast<float>(rectangle->y)};
    const ImVec2 to{from.x + static_cast<float>(rectangle->width), from.y + static_cast<float>(rectangle->height)};
    ImVec4 fill = palette().accent;
    fill.w = 0.15F;
    canvas.AddRectFilled(from, to, ImGui::GetColorU32(fill));
    canvas.AddRect(from, to, ImGui::GetColorU32(palette().accent), 0.0F, 0, scale);
  }
  canvas.PopClipRect();
}

void modeButtons(PanelContext& context, SelectionMode mode, const char* prefix, float width) {
  static constexpr std::array<Segment, 2> modes{{{"rectangle", "Rectangle (B)"}, {"border", "Border (L)"}}};
  constexpr std::size_t none = modes.size();
  const std::size_t chosen = mode == SelectionMode::Off ? none : static_cast<std::size_t>(mode) - 1;
  ImGui::SetNextItemWidth(width);
  const std::size_t next = segments(context, prefix, modes, chosen);
  if (next != chosen) {
    request(context, next == 0 ? UiAction::SelectRectangle : UiAction::SelectBorder);
  }
}

}  // namespace

void selectRow(PanelContext& context) {
  beginRow(context, "Select");
  modeButtons(context, context.stats.selection.mode, "select", ImGui::CalcItemWidth());
}

void selectionBox(PanelContext& context, const UiRect& view) {
  const SelectionView& selection = context.stats.selection;
  if (selection.mode == SelectionMode::Off && selection.points.empty()) {
    return;
  }
  drawSelection(selection, view, context.scale);
  beginModeBox(context, "overlay.selection", view);
  const float all = modeBoxWidth(context, view);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + all);
  ImGui::TextUnformatted(context
                             .texts("{} selected, {} of them pinned",
                                    text::formatCount(static_cast<long long>(selection.points.size())),
                                    selection.pinned)
                             .c_str());
  if (selection.mode != SelectionMode::Off) {
    mutedText(context.texts(selection.mode == SelectionMode::Rectangle ? rectangleHelp : borderHelp));
  }
  modeButtons(context, selection.mode, "selection", all);
  ButtonRow row(context, all, {"Pin (P)", "Release", "Done (Esc)"});
  if (row.button(context, "pin_selected", "Pin (P)", true, true)) {
    request(context, UiAction::PinSelected);
  }
  explainItem(context, "pin_selected", "Pins the selected vertices where they are.");
  if (row.button(context, "release_selected", "Release")) {
    request(context, UiAction::ReleaseSelected);
  }
  explainItem(context, "release_selected", "Releases the selected vertices. P does it when all of them are pinned.");
  if (row.button(context, "end_selection", "Done (Esc)")) {
    request(context, UiAction::EndSelection);
  }
  pinKeyRows(context, selection.vertices, all);
  ImGui::PopTextWrapPos();
  endCorner();
}

}  // namespace drape::ui
