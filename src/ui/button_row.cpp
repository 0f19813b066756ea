#include "ui/button_row.hpp"

#include "ui/widgets.hpp"

#include <utility>

namespace drape::ui {

ButtonRow::ButtonRow(const PanelContext& context, float width, std::initializer_list<const char*> words)
    : right_(ImGui::GetCursorPosX() + width) {
  const auto count = static_cast<float>(words.size());
  width_ = (width - (count - 1.0F) * ImGui::GetStyle().ItemSpacing.x) / count;
  for (const char* word : words) {
    width_ = widthOfButton(context, word, width_);
  }
}

bool ButtonRow::button(PanelContext& context, const char* name, const char* word, bool isEnabled, bool strong) {
  if (std::exchange(isFollowing_, true)) {
    ImGui::SameLine();
    if (ImGui::GetCursorPosX() + width_ > right_ + 1.0F) {
      ImGui::NewLine();
    }
  }
  ImGui::BeginDisabled(!isEnabled);
  const bool pressed = iconButton(context, name, Icon::None, word, width_, strong);
  ImGui::EndDisabled();
  return pressed;
}

}  // namespace drape::ui
