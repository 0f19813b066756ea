#include "ui/command_palette.hpp"

#include "ui/overlay_stack.hpp"
#include "ui/setting_text.hpp"
#include "ui/setting_widget.hpp"
#include "ui/widgets.hpp"

#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

namespace drape::ui {
namespace {

constexpr float wantedWidth = 560.0F;  // at scale 1
constexpr int maxRows = 11;

bool isPressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

/// The right half of a row: the value of a setting, the keys of a command, the name of a scene.
std::string detailOf(const PanelContext& context, const SearchEntry& entry) {
  if (const auto* setting = std::get_if<const settings::SettingInfo*>(&entry.target)) {
    return context.texts(valueInWords(**setting, context.settings));
  }
  return std::holds_alternative<SceneTarget>(entry.target) ? context.texts("open  {}", entry.key)
                                                           : keysInWords(entry.key, context.texts);
}

bool applies(const PanelContext& context, const SearchEntry& entry) {
  const auto* setting = std::get_if<const settings::SettingInfo*>(&entry.target);
  return setting == nullptr || settingApplies(**setting, context.settings, *context.snapshot.scene);
}

/// The meaning of the chosen entry, below the rows. Its height is fixed, so that the box does not jump.
void drawHelp(const PanelContext& context, const SearchEntry* entry, float width) {
  ImGui::BeginChild("help", {width, 3.0F * ImGui::GetTextLineHeight()});
  if (entry == nullptr) {
    mutedText(context.texts("Nothing fits. Try another word, or a part of it."));
  } else if (!applies(context, *entry)) {
    mutedText(context.texts("Has no effect in this scene with the present settings. {}", entry->help),
              palette().warning);
  } else {
    mutedText(entry->help);
  }
  ImGui::EndChild();
}

/// Letters that arrive before the text field has the focus.
std::string earlyLetters() {
  constexpr ImWchar firstPrintable = 0x20;
  constexpr ImWchar erase = 0x7f;
  std::string letters;
  for (const ImWchar letter : ImGui::GetIO().InputQueueCharacters) {
    if (letter >= firstPrintable && letter < erase) {
      letters += static_cast<char>(letter);
    }
  }
  return letters;
}

/// A field that gets the focus selects its text, and the next letter would replace it.
int putCursorAtEnd(ImGuiInputTextCallbackData* data) {
  data->CursorPos = data->BufTextLen;
  data->ClearSelection();
  return 0;
}

}  // namespace

void CommandPalette::open(std::vector<SearchEntry> entries) {
  *this = CommandPalette();
  isOpen_ = true;
  entries_ = std::move(entries);
  isStale_ = true;
}

/// Entries without effect here come last.
void CommandPalette::find(const PanelContext& context) {
  if (!std::exchange(isStale_, false)) {
    return;
  }
  found_ = findEntries(entries_, text_);
  std::ranges::stable_partition(found_, [&](std::size_t i) { return applies(context, entries_[i]); });
  chosen_ = 0;
  scrollsUp_ = true;
}

/// Whether Return takes the chosen entry.
bool CommandPalette::readKeys() {
  if (isPressed(ImGuiKey_Escape)) {
    close();
  }
  const std::size_t count = found_.size();
  if (count > 0 && isPressed(ImGuiKey_DownArrow)) {
    chosen_ = (chosen_ + 1) % count;
    follows_ = true;
  }
  if (count > 0 && isPressed(ImGuiKey_UpArrow)) {
    chosen_ = (chosen_ + count - 1) % count;
    follows_ = true;
  }
  return isPressed(ImGuiKey_Enter) || isPressed(ImGuiKey_KeyPadEnter);
}

bool CommandPalette::drawRow(PanelContext& context, const SearchEntry& entry, std::size_t row, float width) {
  ImGui::PushID(static_cast<int>(row));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool chosen = row == chosen_;
  ImGui::PushStyleColor(ImGuiCol_Header, chosen ? palette().accentFill : ImVec4(0.0F, 0.0F, 0.0F, 0.0F));
  const bool clicked = ImGui::Selectable("##row", chosen, 0, {width, 0.0F});
  ImGui::PopStyleColor();
  context.buttons["search." + (entry.key.empty() ? entry.english : entry.key)] = lastItemRect();
  if (chosen && std::exchange(follows_, false)) {
    ImGui::SetScrollHereY();
  }
  const std::string detail = fitted(detailOf(context, entry), 0.5F * width);
  const float detailWidth = ImGui::CalcTextSize(detail.c_str()).x;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const std::string title = fitted(entry.title, width - detailWidth - 3.0F * gap);
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  const ImVec4& colour = applies(context, entry) ? palette().text : palette().muted;
  canvas.AddText({at.x + gap, at.y}, ImGui::GetColorU32(colour), title.c_str());
  canvas.AddText({at.x + width - detailWidth - gap, at.y}, ImGui::GetColorU32(palette().muted), detail.c_str());
  ImGui::PopID();
  return clicked;
}

void CommandPalette::drawRows(PanelContext& context, float width, int rows) {
  const float height = static_cast<float>(rows) * ImGui::GetTextLineHeightWithSpacing();
  ImGui::BeginChild("rows", {width, height});
  if (std::exchange(scrollsUp_, false)) {
    ImGui::SetScrollY(0.0F);
  }
  const float inner = ImGui::GetContentRegionAvail().x;
  for (std::size_t row = 0; row < found_.size(); ++row) {
    if (drawRow(context, entries_[found_[row]], row, inner)) {
      clicked_ = row;
    }
  }
  ImGui::EndChild();
}

void CommandPalette::take(PanelContext& context, const SearchEntry& entry) {
  close();
  if (const auto* setting = std::get_if<const settings::SettingInfo*>(&entry.target)) {
    context.memory.revealed = {std::string((*setting)->key), ImGui::GetTime(), true};
    if (!applies(context, entry)) {
      context.output.hint =
          text::Sentence("{} has no effect in this scene with the present settings", text::Sentence((*setting)->title));
    }
  } else if (const auto* shortcut = std::get_if<const Shortcut*>(&entry.target)) {
    request(**shortcut, context.snapshot, context.output);
  } else {
    context.output.requests.emplace_back(OpenSceneRequest{std::get<SceneTarget>(entry.target).nameOrPath});
  }
}

void CommandPalette::editText(const PanelContext& context, float width) {
  if (!ImGui::IsAnyItemActive()) {
    ImGui::SetKeyboardFocusHere();
  }
  if (!hadFocus_) {
    // The field would lose the letters of the frame in which it gets the focus.
    text_ += earlyLetters();
    ImGui::GetIO().ClearInputCharacters();
  }
  ImGui::SetNextItemWidth(width);
  ImGui::InputTextWithHint("##search", context.texts("Type a word; arrows and Return choose").c_str(), &text_,
                           hadFocus_ ? 0 : ImGuiInputTextFlags_CallbackAlways, putCursorAtEnd);
  hadFocus_ = ImGui::IsItemActive();
}

void CommandPalette::draw(PanelContext& context, const UiRect& view) {
  const float padding = 18.0F * context.scale;
  const float width = std::min(wantedWidth * context.scale, static_cast<float>(view.width) - 2.0F * padding);
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const int fitting = static_cast<int>((static_cast<float>(view.height) - 8.0F * line) / line);
  beginDialog(context, view, "search", "Find a setting, a command or a scene");
  editText(context, width);
  context.buttons["search.text"] = lastItemRect();
  const bool entered = readKeys();
  isStale_ = isStale_ || text_ != searched_;
  searched_ = text_;
  find(context);
  drawRows(context, width, std::clamp(fitting, 3, maxRows));
  drawHelp(context, chosen_ < found_.size() ? &entries_[found_[chosen_]] : nullptr, width);
  const std::optional<std::size_t> taken = entered && chosen_ < found_.size() ? std::optional(chosen_) : clicked_;
  const bool beside = clickedBeside();
  endDialog();
  if (taken) {
    take(context, SearchEntry(entries_[found_[*taken]]));
  } else if (beside) {
    close();
  }
}

}  // namespace drape::ui
