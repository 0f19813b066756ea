#include "ui/overlay_stack.hpp"

#include <imgui_internal.h>  // for the size that a window had

#include <algorithm>
#include <cmath>
#include <utility>

namespace drape::ui {
namespace {

constexpr ImGuiWindowFlags overlayFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                          ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
constexpr int styleVariables = 3;
constexpr float modeBoxMargin = 12.0F;  // around and inside the box of a mode, at scale 1
constexpr float widestText = 44.0F;     // [heights of the text]

void remember(PanelContext& context, const std::string& name) {
  const ImVec2 at = ImGui::GetWindowPos();
  const ImVec2 size = ImGui::GetWindowSize();
  context.buttons[name] = {at.x, at.y, size.x, size.y};
}

void pushStyle(float padding, float opacity) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, padding * 0.5F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(std::round(padding), std::round(padding * 0.7F)));
  ImVec4 background = palette().overlay;
  background.w = opacity;
  ImGui::PushStyleColor(ImGuiCol_WindowBg, background);
}

/// A range along x [window units].
struct Span {
  float low = 0.0F;
  float high = 0.0F;
};

/// The part of the picture beside the box of a mode, if the box is at the top and leaves enough room.
Span besideModeBox(const UiRect& view) {
  constexpr double top = 0.3;          // of the height of the picture
  constexpr float enoughRoom = 20.0F;  // [heights of the text]
  const Span whole{static_cast<float>(view.x), static_cast<float>(view.x + view.width)};
  Span free = whole;
  for (const char* name : {"overlay.placing", "overlay.selection", "overlay.sewing"}) {
    const ImGuiWindow* box = ImGui::FindWindowByName(name);
    if (box == nullptr || !box->WasActive || static_cast<double>(box->Pos.y) > view.y + top * view.height) {
      continue;
    }
    if (box->Pos.x + 0.5F * box->Size.x < 0.5F * (whole.low + whole.high)) {
      free.low = std::max(free.low, box->Pos.x + box->Size.x);
    } else {
      free.high = std::min(free.high, box->Pos.x);
    }
  }
  return free.high - free.low > enoughRoom * ImGui::GetFontSize() ? free : whole;
}

/// Puts the next window, a dialog, into the middle of the view, but never beyond the edges of the window. A dialog
/// wider than the view covers some of the panels. A higher one scrolls.
void placeDialog(const UiRect& view, const char* name) {
  const ImGuiWindow* before = ImGui::FindWindowByName(name);
  const float half = before == nullptr ? 0.0F : 0.5F * before->Size.x;
  const float width = ImGui::GetIO().DisplaySize.x;
  const auto middle = static_cast<float>(view.x + view.width * 0.5);
  ImGui::SetNextWindowPos(
      {std::max(half, std::min(middle, width - half)), static_cast<float>(view.y + view.height * 0.5)},
      ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {width, static_cast<float>(view.height)});
}

void popStyle() {
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(styleVariables);
}

}  // namespace

OverlayStack::OverlayStack(PanelContext& context, const UiRect& view)
    : context_(context), bottom_(static_cast<float>(view.y + view.height)), padding_(12.0F * context.scale) {
  const Span free = besideModeBox(view);
  centre_ = 0.5F * (free.low + free.high);
  textWidth_ = std::min(free.high - free.low - 4.0F * padding_, widestText * ImGui::GetFontSize());
  top_ = static_cast<float>(view.y) + padding_;
}

float OverlayStack::heightBelow() const {
  return std::max(ImGui::GetTextLineHeight(), 0.6F * (bottom_ - top_) - 2.0F * padding_);
}

void OverlayStack::begin(const std::string& name, Mouse mouse) {
  const bool taken = mouse == Mouse::Taken;
  ImGui::SetNextWindowPos({centre_, top_}, ImGuiCond_Always, {0.5F, 0.0F});
  pushStyle(padding_, taken ? 0.97F : 0.8F);
  ImGui::Begin(("overlay." + name).c_str(), nullptr, overlayFlags | (taken ? 0 : ImGuiWindowFlags_NoInputs));
  remember(context_, (taken ? "overlay." : "hint.") + name);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + textWidth_);
}

void OverlayStack::end() {
  ImGui::PopTextWrapPos();
  top_ += ImGui::GetWindowSize().y + padding_ * 0.5F;
  ImGui::End();
  popStyle();
}

void OverlayStack::progressBar(double share) const {
  const float line = ImGui::GetFontSize();
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, palette().accent);
  ImGui::ProgressBar(static_cast<float>(share), {std::min(textWidth_, 20.0F * line), 0.3F * line}, "");
  ImGui::PopStyleColor();
}

void beginCorner(PanelContext& context, const std::string& name, const ImVec2& at, const ImVec2& pivot,
                 OverlayStack::Mouse mouse) {
  const bool taken = mouse == OverlayStack::Mouse::Taken;
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
  pushStyle(12.0F * context.scale, 0.9F);
  ImGui::Begin(name.c_str(), nullptr, overlayFlags | (taken ? 0 : ImGuiWindowFlags_NoInputs));
  remember(context, name);
}

float modeBoxWidth(const PanelContext& context, const UiRect& view) {
  constexpr float narrowest = 9.0F;  // [heights of the text]
  constexpr float usual = 18.0F;     // [heights of the text]
  const float margin = modeBoxMargin * context.scale;
  const float around = 4.0F * margin + ImGui::GetStyle().ScrollbarSize;  // two margins and two paddings
  return std::clamp(static_cast<float>(view.width) - around, narrowest * ImGui::GetFontSize(),
                    usual * ImGui::GetFontSize());
}

namespace {

/// The place nearest to `at` where the whole of a side is in a range.
float within(float at, float side, double low, double range) {
  const auto first = static_cast<float>(low);
  return std::clamp(at, first, std::max(first, first + static_cast<float>(range) - side));
}

bool differ(const UiRect& a, const UiRect& b) {
  return a.x != b.x || a.y != b.y || a.width != b.width || a.height != b.height;
}

/// At first the corner of the picture. The user may have dragged the box elsewhere; where the picture or the size of
/// the box becomes another one, the box stays in the picture.
void placeModeBox(PanelContext& context, const std::string& name, const UiRect& view, float margin) {
  ImGui::SetNextWindowPos({static_cast<float>(view.x) + margin, static_cast<float>(view.y) + margin},
                          ImGuiCond_Appearing);
  const ImGuiWindow* before = ImGui::FindWindowByName(name.c_str());
  if (before == nullptr || !before->WasActive) {
    return;
  }
  const UiRect size{0.0, 0.0, before->Size.x, before->Size.y};
  const bool isOtherView = differ(std::exchange(context.memory.modeBoxView, view), view);
  const bool isOtherSize = differ(std::exchange(context.memory.modeBoxSize, size), size);
  if (isOtherView || isOtherSize) {
    ImGui::SetNextWindowPos({within(before->Pos.x, before->Size.x, view.x, view.width),
                             within(before->Pos.y, before->Size.y, view.y, view.height)});
  }
}

}  // namespace

void beginModeBox(PanelContext& context, const std::string& name, const UiRect& view) {
  const float margin = modeBoxMargin * context.scale;
  ImGui::SetNextWindowSizeConstraints(
      {0.0F, 0.0F}, {static_cast<float>(view.width), static_cast<float>(view.height) - 2.0F * margin});
  placeModeBox(context, name, view, margin);
  pushStyle(margin, 0.9F);
  ImGui::Begin(name.c_str(), nullptr, overlayFlags & ~(ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoScrollbar));
  remember(context, name);
}

void endCorner() {
  ImGui::End();
  popStyle();
}

void beginDialog(PanelContext& context, const UiRect& view, const std::string& name, const Wording& title) {
  const float padding = 18.0F * context.scale;
  const std::string window = "dialog." + name;
  placeDialog(view, window.c_str());
  pushStyle(padding, 0.97F);
  ImGui::Begin(window.c_str(), nullptr, overlayFlags & ~ImGuiWindowFlags_NoScrollbar);
  ImGui::PushTextWrapPos(ImGui::GetIO().DisplaySize.x - padding);
  remember(context, "overlay." + name);
  ImGui::PushFont(context.fonts.title);
  ImGui::TextUnformatted(context.texts(title).c_str());
  ImGui::PopFont();
  ImGui::Spacing();
}

// A pressed button is active and must not block the test.
bool clickedBeside() {
  constexpr ImGuiHoveredFlags anywhere = ImGuiHoveredFlags_AnyWindow | ImGuiHoveredFlags_AllowWhenBlockedByActiveItem;
  return ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsWindowHovered(anywhere);
}

void endDialog() {
  ImGui::PopTextWrapPos();
  ImGui::End();
  popStyle();
}

}  // namespace drape::ui
