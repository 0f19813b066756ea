#include "ui/widgets.hpp"

#include "text/words.hpp"
#include "ui/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace drape::ui {
namespace {

constexpr float labelShare = 0.4F;   // of a row's width
constexpr double hoverDelay = 0.45;  // [s]
constexpr float iconSide = 11.0F;    // at scale 1

ImVec2 operator+(const ImVec2& a, const ImVec2& b) {
  return {a.x + b.x, a.y + b.y};
}

void drawPlay(ImDrawList& canvas, ImVec2 at, float side, ImU32 colour) {
  canvas.AddTriangleFilled(at + ImVec2(side * 0.1F, 0.0F), at + ImVec2(side, side * 0.5F),
                           at + ImVec2(side * 0.1F, side), colour);
}

void drawPause(ImDrawList& canvas, ImVec2 at, float side, ImU32 colour) {
  canvas.AddRectFilled(at + ImVec2(side * 0.1F, 0.0F), at + ImVec2(side * 0.38F, side), colour);
  canvas.AddRectFilled(at + ImVec2(side * 0.62F, 0.0F), at + ImVec2(side * 0.9F, side), colour);
}

void drawStep(ImDrawList& canvas, ImVec2 at, float side, ImU32 colour) {
  canvas.AddTriangleFilled(at, at + ImVec2(side * 0.7F, side * 0.5F), at + ImVec2(0.0F, side), colour);
  canvas.AddRectFilled(at + ImVec2(side * 0.74F, 0.0F), at + ImVec2(side, side), colour);
}

void drawReset(ImDrawList& canvas, ImVec2 at, float side, ImU32 colour) {
  canvas.AddRectFilled(at, at + ImVec2(side * 0.2F, side), colour);
  canvas.AddTriangleFilled(at + ImVec2(side, 0.0F), at + ImVec2(side, side), at + ImVec2(side * 0.26F, side * 0.5F),
                           colour);
}

void drawIcon(Icon icon, ImDrawList& canvas, ImVec2 at, float side, ImU32 colour) {
  switch (icon) {
    case Icon::None:
      break;
    case Icon::Play:
      drawPlay(canvas, at, side, colour);
      break;
    case Icon::Pause:
      drawPause(canvas, at, side, colour);
      break;
    case Icon::Step:
      drawStep(canvas, at, side, colour);
      break;
    case Icon::Reset:
      drawReset(canvas, at, side, colour);
      break;
  }
}

void textAt(ImDrawList& canvas, ImVec2 at, const ImVec4& colour, std::string_view text) {
  canvas.AddText(at, ImGui::GetColorU32(colour), text.data(), text.data() + text.size());
}

ImVec2 sizeOf(std::string_view text) {
  return ImGui::CalcTextSize(text.data(), text.data() + text.size());
}

}  // namespace

UiRect lastItemRect() {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  return {low.x, low.y, high.x - low.x, high.y - low.y, ImGui::IsItemVisible()};
}

std::string prettyUnit(std::string_view unit) {
  std::string pretty;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const bool power = unit[i] == '^' && i + 1 < unit.size() && (unit[i + 1] == '2' || unit[i + 1] == '3');
    if (power) {
      pretty += unit[++i] == '2' ? "\u00B2" : "\u00B3";
    } else {
      pretty += unit[i];
    }
  }
  return pretty;
}

text::Sentence unitInWords(std::string_view unit) {
  return unit == "degrees" ? text::Sentence("degrees") : text::Sentence::verbatim(prettyUnit(unit));
}

float widthBesideArrow() {
  return ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - 2.0F * ImGui::GetStyle().FramePadding.x;
}

std::string fitted(std::string_view text, float width) {
  std::string cut(text);
  for (std::size_t limit = text.size(); limit > 1 && sizeOf(cut).x > width; --limit) {
    cut = shortened(text, limit - 1);
  }
  return cut;
}

std::string labelOf(const PanelContext& context, const Wording& wording, std::string_view name) {
  return context.texts(wording) + "###" + std::string(name);
}

namespace {

float widthOfLongestWord(std::string_view text) {
  float widest = 0.0F;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find(' '), text.size());
    widest = std::max(widest, sizeOf(text.substr(0, length)).x);
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return widest;
}

/// Draws the label of a row in the column at the left, in as many lines as it needs. One with a word that is too long
/// for the column stands above the widget instead. Moves the cursor to the widget.
/// @param column where the widget begins, in the window  @return the height of the row [window units]
float rowLabel(const PanelContext& context, const std::string& label, float column) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float left = ImGui::GetCursorPosX();
  const float room = column - left - 4.0F * context.scale;
  const bool isAbove = widthOfLongestWord(label) > room;
  ImGui::AlignTextToFramePadding();
  ImGui::PushTextWrapPos(isAbove ? 0.0F : left + room);
  ImGui::TextUnformatted(label.c_str());
  ImGui::PopTextWrapPos();
  context.labels[label] = lastItemRect();
  const float height = style.FramePadding.y + ImGui::GetItemRectSize().y;
  if (isAbove) {
    ImGui::SetCursorPosX(column);
    return height + style.ItemSpacing.y + ImGui::GetFrameHeight();
  }
  ImGui::SameLine(column);
  return std::max(height, ImGui::GetFrameHeight());
}

}  // namespace

UiRect beginRow(const PanelContext& context, const Wording& wording, bool marked) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float middle = at.y + 0.5F * ImGui::GetFrameHeight();
  if (marked) {
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x - 7.0F * context.scale, middle}, 2.2F * context.scale,
                                                ImGui::GetColorU32(palette().accent));
  }
  ImGui::PushStyleColor(ImGuiCol_Text, marked ? palette().text : palette().muted);
  const float column = std::round(ImGui::GetCursorStartPos().x + width * labelShare);
  const float height = rowLabel(context, context.texts(wording), column);
  ImGui::PopStyleColor();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  return {at.x, at.y, width, height};
}

void valueRow(const PanelContext& context, const Wording& wording, std::string_view value, const ImVec4& colour) {
  const std::string label = context.texts(wording);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  textAt(canvas, at, palette().muted, label);
  textAt(canvas, {at.x + width - sizeOf(value).x, at.y}, colour, value);
  ImGui::Dummy({width, ImGui::GetTextLineHeight()});
}

void factRow(const PanelContext& context, const Wording& wording, std::string_view fact) {
  const std::string label = context.texts(wording);
  const float start = std::round(ImGui::GetCursorStartPos().x + ImGui::GetContentRegionAvail().x * labelShare);
  mutedText(label);
  ImGui::SameLine(start);
  mutedText(fact, palette().text);
}

bool hoversRow(const UiRect& row) {
  const ImVec2 low{static_cast<float>(row.x), static_cast<float>(row.y)};
  const ImVec2 high{static_cast<float>(row.x + row.width), static_cast<float>(row.y + row.height)};
  return ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
         ImGui::IsMouseHoveringRect(low, high);
}

bool hoveredLongEnough(const PanelContext& context, const std::string& name) {
  PanelMemory& memory = context.memory;
  memory.hoveredThisFrame = true;
  if (memory.hoveredRow != name || ImGui::IsAnyMouseDown() || ImGui::GetIO().WantTextInput) {
    memory.hoveredRow = name;
    memory.hoveredSince = ImGui::GetTime();
  }
  return ImGui::GetTime() - memory.hoveredSince > hoverDelay;
}

void beginExplanation(const PanelContext& context, const UiRect* row) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const ImVec2 padding(ImGui::GetFontSize() * 0.7F, ImGui::GetFontSize() * 0.55F);
  const float textWidth = std::min(ImGui::GetFontSize() * 22.0F, display.x - 2.0F * padding.x);
  if (row != nullptr) {
    const bool upper = row->y < static_cast<double>(display.y) * 0.6;
    const double beside = row->x + row->width + static_cast<double>(30.0F * context.scale);
    const float last = display.x - textWidth - 2.0F * padding.x;  // from which all of it is in the window
    ImGui::SetNextWindowPos(
        {std::min(static_cast<float>(beside), last), static_cast<float>(upper ? row->y : row->y + row->height)},
        ImGuiCond_Always, {0.0F, upper ? 0.0F : 1.0F});
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(textWidth);
}

void endExplanation() {
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void explainItem(const PanelContext& context, const std::string& name, const Wording& sentence) {
  if (ImGui::IsItemHovered() && hoveredLongEnough(context, name)) {
    beginExplanation(context);
    ImGui::TextWrapped("%s", context.texts(sentence).c_str());
    endExplanation();
  }
}

void mutedText(std::string_view text, const ImVec4& colour) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void steadyText(PanelContext& context, const std::string& name, const std::string& text, const ImVec4& colour) {
  const float width = ImGui::GetContentRegionAvail().x;
  float& height = context.memory.textHeights[name];
  if (!ImGui::IsAnyItemActive()) {
    height = text.empty() ? 0.0F : ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y;
  }
  if (height <= 0.0F) {
    return;
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec4 clip(at.x, at.y, at.x + width, at.y + height);
  ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, ImGui::GetColorU32(colour),
                                      text.c_str(), nullptr, width, &clip);
  ImGui::Dummy({width, height});
}

bool iconButton(PanelContext& context, const std::string& name, Icon icon, const Wording& wording, float width,
                bool strong) {
  const std::string word = context.texts(wording);
  const float height = std::round(ImGui::GetFrameHeight() * 1.15F);
  ImGui::PushID(name.c_str());
  if (strong) {
    ImGui::PushStyleColor(ImGuiCol_Button, palette().accentFill);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, palette().accentHovered);
  }
  const bool pressed = ImGui::Button("##button", {width, height});
  ImGui::PopStyleColor(strong ? 2 : 0);
  ImGui::PopID();
  context.buttons["button." + name] = lastItemRect();
  const ImVec2 low = ImGui::GetItemRectMin();
  const float side = icon == Icon::None ? 0.0F : std::round(iconSide * context.scale);
  const float gap = icon == Icon::None ? 0.0F : 7.0F * context.scale;
  const ImVec2 text = sizeOf(word);
  const float left = low.x + std::round((width - side - gap - text.x) * 0.5F);
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  drawIcon(icon, canvas, {left, low.y + std::round((height - side) * 0.5F)}, side, ImGui::GetColorU32(palette().text));
  textAt(canvas, {left + side + gap, low.y + std::round((height - text.y) * 0.5F)}, palette().text, word);
  return pressed;
}

float widthOfButton(const PanelContext& context, const Wording& word, float width) {
  return std::max(width, std::ceil(sizeOf(context.texts(word)).x) + 2.0F * ImGui::GetStyle().FramePadding.x);
}

namespace {

/// Equal widths where all titles fit, else widths in proportion to the titles; in more than one line those of the
/// titles.
std::vector<float> segmentWidths(const PanelContext& context, std::span<const Segment> choices, float all) {
  std::vector<float> widths;
  float sum = 0.0F;
  for (const Segment& choice : choices) {
    const Wording title = choice.isName ? Wording(text::Sentence::verbatim(choice.title)) : Wording(choice.title);
    sum += widths.emplace_back(widthOfButton(context, title, 0.0F));
  }
  const float equal = all / static_cast<float>(choices.size());
  const bool allFit = std::ranges::all_of(widths, [&](float width) { return width <= equal; });
  for (float& width : widths) {
    width = allFit ? equal : width * std::max(1.0F, all / sum);
  }
  return widths;
}

}  // namespace

std::size_t segments(PanelContext& context, const std::string& name, std::span<const Segment> choices,
                     std::size_t chosen) {
  std::size_t result = chosen;
  const float gap = std::round(2.0F * context.scale);
  const auto count = static_cast<float>(choices.size());
  const float all = ImGui::CalcItemWidth() - gap * (count - 1.0F);
  const std::vector<float> widths = segmentWidths(context, choices, all);
  const float left = ImGui::GetCursorPosX();
  const float right = left + ImGui::CalcItemWidth();
  ImGui::PushID(name.c_str());
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) {
      ImGui::SameLine(0.0F, gap);
    }
    if (i > 0 && ImGui::GetCursorPosX() + widths[i] > right + 1.0F) {
      ImGui::NewLine();
      ImGui::SetCursorPosX(left);
    }
    ImGui::PushStyleColor(ImGuiCol_Button, i == chosen ? palette().accentFill : palette().field);
    ImGui::PushStyleColor(ImGuiCol_Text, i == chosen ? palette().text : palette().muted);
    if (ImGui::Button(
            labelOf(context, choices[i].isName ? Wording(text::Sentence::verbatim(choices[i].title)) : choices[i].title,
                    choices[i].word)
                .c_str(),
            {widths[i], ImGui::GetFrameHeight()})) {
      result = i;
    }
    ImGui::PopStyleColor(2);
    context.buttons[name + "=" + std::string(choices[i].word)] = lastItemRect();
  }
  ImGui::PopID();
  return result;
}

bool beginSection(PanelContext& context, const std::string& title, bool openAtFirst, bool openNow) {
  ImGui::Separator();
  std::map<std::string, bool>& kept = context.memory.sections;
  const auto left = kept.find(title);
  const std::optional<bool> all = openNow ? std::optional(true) : context.memory.openSections;
  ImGui::SetNextItemOpen(all.value_or(left == kept.end() ? openAtFirst : left->second),
                         all ? ImGuiCond_Always : ImGuiCond_Once);
  const bool open = ImGui::CollapsingHeader(labelOf(context, title, title).c_str());
  if (ImGui::IsItemToggledOpen()) {
    kept[title] = open;
  }
  context.buttons["section." + text::lowerCase(title)] = lastItemRect();
  if (open) {
    ImGui::PushID(title.c_str());
    ImGui::Indent();
  }
  return open;
}

bool beginFold(PanelContext& context, const std::string& title, const std::string& name, bool openNow) {
  const std::optional<bool> all = openNow ? std::optional(true) : context.memory.openSections;
  ImGui::SetNextItemOpen(all.value_or(false), all ? ImGuiCond_Always : ImGuiCond_Once);
  const bool open = ImGui::TreeNodeEx(labelOf(context, title, name).c_str(),
                                      ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth);
  context.buttons["fold." + name] = lastItemRect();
  return open;
}

void revealRow(PanelContext& context, const std::string& key, const UiRect& row) {
  constexpr double markTime = 2.5;  // [s]
  RevealedRow& revealed = context.memory.revealed;
  if (revealed.key != key) {
    return;
  }
  constexpr float place = 0.35F;  // share of the column above the row
  if (std::exchange(revealed.isPending, false)) {
    ImGui::SetScrollHereY(place);
    revealed.since = ImGui::GetTime();
  }
  const double age = ImGui::GetTime() - revealed.since;
  if (age > markTime) {
    revealed = {};
    return;
  }
  ImVec4 colour = palette().accent;
  colour.w = static_cast<float>(1.0 - age / markTime);
  const float margin = 3.0F * context.scale;
  const ImVec2 low{static_cast<float>(row.x) - margin, static_cast<float>(row.y) - margin};
  const ImVec2 high{static_cast<float>(row.x + row.width) + margin, static_cast<float>(row.y + row.height) + margin};
  ImGui::GetWindowDrawList()->AddRect(low, high, ImGui::GetColorU32(colour), 2.0F * margin, 0, 1.5F * context.scale);
}

void endSection() {
  ImGui::Unindent();
  ImGui::Dummy({0.0F, ImGui::GetStyle().ItemSpacing.y * 0.5F});
  ImGui::PopID();
}

}  // namespace drape::ui
