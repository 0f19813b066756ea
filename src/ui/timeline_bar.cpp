#include "text/number_text.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <string>

namespace drape::ui {
namespace {

/// A line from the oldest to the newest state with a knob at the present one. Dragging the knob asks for another time.
void timeLine(PanelContext& context, const session::TimelineStatus& timeline, float width) {
  const float height = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const double span = std::max(1e-9, timeline.end - timeline.begin);
  ImGui::InvisibleButton("line", {width, height});
  context.buttons["timeline"] = lastItemRect();
  const bool active = ImGui::IsItemActive();
  const bool hovered = ImGui::IsItemHovered();
  const float radius = std::round(0.38F * height);
  const float left = at.x + radius;
  const float right = at.x + width - radius;
  if (active) {
    const float share = std::clamp((ImGui::GetIO().MousePos.x - left) / (right - left), 0.0F, 1.0F);
    const double time = timeline.begin + static_cast<double>(share) * span;
    if (context.memory.scrubbed != time) {
      context.memory.scrubbed = time;
      context.output.commands.emplace_back(session::GoToCommand{time});
    }
  } else {
    context.memory.scrubbed.reset();
  }
  const double place = std::clamp((context.snapshot.time - timeline.begin) / span, 0.0, 1.0);
  const float x = left + (right - left) * static_cast<float>(place);
  const float y = at.y + 0.5F * height;
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  const float thickness = 3.0F * context.scale;
  canvas.AddLine({left, y}, {right, y}, ImGui::GetColorU32(palette().field), thickness);
  canvas.AddLine({left, y}, {x, y}, ImGui::GetColorU32(palette().accentFill), thickness);
  canvas.AddCircleFilled({x, y}, radius, ImGui::GetColorU32(active || hovered ? palette().text : palette().accent));
}

}  // namespace

float timelineBar(PanelContext& context, const UiRect& view) {
  const auto& timeline = context.snapshot.timeline;
  if (!timeline || timeline->states < 2) {
    return 0.0F;
  }
  const float margin = 12.0F * context.scale;
  const std::string present = fmt::format("{:.2f} s", context.snapshot.time);
  const std::string size =
      context.texts("{} to {} s, {} MB", fmt::format("{:.2f}", timeline->begin), fmt::format("{:.2f}", timeline->end),
                    text::roundedFigure(timeline->megabytes, 2));
  beginCorner(context, "overlay.timeline",
              {static_cast<float>(view.x + 0.5 * view.width), static_cast<float>(view.y + view.height) - margin},
              {0.5F, 1.0F}, OverlayStack::Mouse::Taken);
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float numbers = ImGui::CalcTextSize("00.00 s").x;
  const float facts = ImGui::CalcTextSize(context.texts("{} to {} s, {} MB", "00.00", "00.00", "000").c_str()).x;
  // A narrow window has room for the line only.
  const bool isNarrow = static_cast<float>(view.width) < 3.0F * facts;
  const float width = static_cast<float>(view.width) - 4.0F * margin - numbers - (isNarrow ? 0.0F : facts + gap) - gap;
  ImGui::TextUnformatted(present.c_str());
  ImGui::SameLine(numbers + gap + ImGui::GetStyle().WindowPadding.x);
  timeLine(context, *timeline, std::max(4.0F * margin, width));
  explainItem(context, "timeline",
              "The recorded states of the last minute. Drag to return to one of them; comma goes back by one. Playing "
              "from there repeats the motion exactly, unless you change something.");
  if (!isNarrow) {
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, palette().muted);
    ImGui::TextUnformatted(size.c_str());
    ImGui::PopStyleColor();
  }
  const float height = ImGui::GetWindowSize().y + 0.5F * margin;
  endCorner();
  return height;
}

}  // namespace drape::ui
