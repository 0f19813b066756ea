// The gizmo of the mode Place, drawn over the picture.
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace drape::ui {
namespace {

/// A colour on the screen, red, green, blue and opacity from 0 to 1.
struct Tint {
  float red, green, blue, opacity;

  [[nodiscard]] ImU32 packed(float share = 1.0F) const {
    return ImGui::GetColorU32(ImVec4(red, green, blue, share * opacity));
  }
};

struct HandleLook {
  const char* name;  // of its grip, for tests and scripts
  Tint tint;
};

constexpr Tint redTint{0.93F, 0.27F, 0.30F, 1.0F};
constexpr Tint greenTint{0.36F, 0.75F, 0.24F, 1.0F};
constexpr Tint blueTint{0.26F, 0.53F, 0.98F, 1.0F};
constexpr Tint whiteTint{0.96F, 0.96F, 0.96F, 1.0F};
constexpr Tint litTint{1.0F, 0.82F, 0.20F, 1.0F};
constexpr Tint outlineTint{0.05F, 0.05F, 0.07F, 0.55F};

HandleLook lookOf(GizmoHandle handle) {
  switch (handle) {
    case GizmoHandle::MoveX:
      return {"gizmo.x", redTint};
    case GizmoHandle::MoveY:
      return {"gizmo.y", greenTint};
    case GizmoHandle::MoveZ:
      return {"gizmo.z", blueTint};
    case GizmoHandle::MoveYZ:
      return {"gizmo.yz", redTint};
    case GizmoHandle::MoveZX:
      return {"gizmo.zx", greenTint};
    case GizmoHandle::MoveXY:
      return {"gizmo.xy", blueTint};
    case GizmoHandle::TurnX:
      return {"gizmo.turn_x", redTint};
    case GizmoHandle::TurnY:
      return {"gizmo.turn_y", greenTint};
    case GizmoHandle::TurnZ:
      return {"gizmo.turn_z", blueTint};
    case GizmoHandle::Size:
      return {"gizmo.size", whiteTint};
    default:
      return {"gizmo.view", whiteTint};
  }
}

ImVec2 toImGui(const Vec2& place) {
  return {static_cast<float>(place.x()), static_cast<float>(place.y())};
}

/// A line with a dark border, which shows on light and dark cloth.
void strongLine(ImDrawList& canvas, const ImVec2& from, const ImVec2& to, ImU32 colour, float width) {
  canvas.AddLine(from, to, outlineTint.packed(), width + 2.0F);
  canvas.AddLine(from, to, colour, width);
}

void drawArrow(ImDrawList& canvas, const GizmoLine& line, ImU32 colour, float scale) {
  const ImVec2 from = toImGui(line.outline.front());
  const ImVec2 tip = toImGui(line.outline.back());
  const Vec2 along = line.outline.back() - line.outline.front();
  const double length = std::max(along.norm(), 1e-6);
  const Vec2 forward = along / length;
  const Vec2 across(-forward.y(), forward.x());
  const double head = std::min(16.0 * static_cast<double>(scale), length);
  const Vec2 base = line.outline.back() - head * forward;
  strongLine(canvas, from, toImGui(base), colour, 3.0F * scale);
  const ImVec2 left = toImGui(base + 0.42 * head * across);
  const ImVec2 right = toImGui(base - 0.42 * head * across);
  canvas.AddTriangle(left, right, tip, outlineTint.packed(), 2.0F);
  canvas.AddTriangleFilled(left, right, tip, colour);
}

std::vector<ImVec2> pointsOf(const GizmoLine& line) {
  std::vector<ImVec2> points;
  std::ranges::transform(line.outline, std::back_inserter(points), toImGui);
  return points;
}

void drawArea(ImDrawList& canvas, const GizmoLine& line, const Tint& tint, float scale) {
  const std::vector<ImVec2> points = pointsOf(line);
  const auto count = static_cast<int>(points.size());
  canvas.AddConvexPolyFilled(points.data(), count, tint.packed(line.isLit ? 0.75F : 0.4F));
  canvas.AddPolyline(points.data(), count, tint.packed(), ImDrawFlags_Closed, 1.5F * scale);
}

void drawRing(ImDrawList& canvas, const GizmoLine& line, ImU32 colour, float scale) {
  const std::vector<ImVec2> points = pointsOf(line);
  const auto count = static_cast<int>(points.size());
  const float width = 2.5F * scale;
  canvas.AddPolyline(points.data(), count, outlineTint.packed(), ImDrawFlags_Closed, width + 2.0F);
  canvas.AddPolyline(points.data(), count, colour, ImDrawFlags_Closed, width);
}

void drawKnob(ImDrawList& canvas, const GizmoLine& line, ImU32 colour, float scale) {
  const ImVec2 from = toImGui(line.outline.front());
  const ImVec2 to = toImGui(line.outline.back());
  const float half = 7.0F * scale;
  strongLine(canvas, from, to, colour, 2.0F * scale);
  canvas.AddCircleFilled(from, 3.5F * scale, colour);
  canvas.AddRectFilled({to.x - half - 1.0F, to.y - half - 1.0F}, {to.x + half + 1.0F, to.y + half + 1.0F},
                       outlineTint.packed());
  canvas.AddRectFilled({to.x - half, to.y - half}, {to.x + half, to.y + half}, colour);
}

void drawHandle(ImDrawList& canvas, const GizmoLine& line, float scale) {
  const Tint tint = line.isLit ? litTint : lookOf(line.handle).tint;
  const ImU32 packed = tint.packed();
  switch (line.handle) {
    case GizmoHandle::MoveX:
    case GizmoHandle::MoveY:
    case GizmoHandle::MoveZ:
      drawArrow(canvas, line, packed, scale);
      break;
    case GizmoHandle::TurnX:
    case GizmoHandle::TurnY:
    case GizmoHandle::TurnZ:
      drawRing(canvas, line, packed, scale);
      break;
    case GizmoHandle::Size:
      drawKnob(canvas, line, packed, scale);
      break;
    default:
      drawArea(canvas, line, tint, scale);
  }
}

}  // namespace

void drawGizmo(PanelContext& context, const PlacingView& placing, const UiRect& view) {
  ImDrawList& canvas = *ImGui::GetBackgroundDrawList();
  const ImVec2 low{static_cast<float>(view.x), static_cast<float>(view.y)};
  canvas.PushClipRect(low, {low.x + static_cast<float>(view.width), low.y + static_cast<float>(view.height)});
  for (const auto& [from, to] : placing.box) {
    canvas.AddLine(toImGui(from), toImGui(to), litTint.packed(0.8F), context.scale);
  }
  for (const GizmoLine& line : placing.handles) {
    drawHandle(canvas, line, context.scale);
    const double half = 3.0 * static_cast<double>(context.scale);
    context.buttons[lookOf(line.handle).name] = {line.grip.x() - half, line.grip.y() - half, 2.0 * half, 2.0 * half};
  }
  canvas.PopClipRect();
}

}  // namespace drape::ui
