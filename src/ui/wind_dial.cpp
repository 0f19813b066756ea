#include "ui/panels.hpp"
#include "ui/setting_widget.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"
#include "ui/wind_mapping.hpp"

#include <cmath>

namespace drape::ui {
namespace {

struct Dial {
  ImVec2 centre;
  float radius = 0.0F;
};

ImVec2 tipOf(const Dial& dial, const Vec3& wind) {
  const Vec2 offset = dialOffset(wind);
  return {dial.centre.x + dial.radius * static_cast<float>(offset.x()),
          dial.centre.y + dial.radius * static_cast<float>(offset.y())};
}

void drawArrow(ImDrawList& canvas, ImVec2 from, ImVec2 to, float scale, ImU32 colour) {
  const float dx = to.x - from.x;
  const float dy = to.y - from.y;
  const float length = std::sqrt(dx * dx + dy * dy);
  if (length < 1.0F) {
    canvas.AddCircleFilled(from, 3.5F * scale, colour);
    return;
  }
  const float ux = dx / length;
  const float uy = dy / length;
  const float head = std::min(9.0F * scale, length);
  const ImVec2 neck{to.x - ux * head, to.y - uy * head};
  canvas.AddLine(from, neck, colour, 2.5F * scale);
  canvas.AddTriangleFilled(to, {neck.x - uy * head * 0.5F, neck.y + ux * head * 0.5F},
                           {neck.x + uy * head * 0.5F, neck.y - ux * head * 0.5F}, colour);
}

void drawDial(const PanelContext& context, const Dial& dial, bool hovered) {
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  const ImU32 line = ImGui::GetColorU32(palette().line);
  canvas.AddCircleFilled(dial.centre, dial.radius, ImGui::GetColorU32(palette().field), 48);
  canvas.AddCircle(dial.centre, dial.radius * 0.5F, line, 32);
  canvas.AddLine({dial.centre.x - dial.radius, dial.centre.y}, {dial.centre.x + dial.radius, dial.centre.y}, line);
  canvas.AddLine({dial.centre.x, dial.centre.y - dial.radius}, {dial.centre.x, dial.centre.y + dial.radius}, line);
  canvas.AddCircle(dial.centre, dial.radius, ImGui::GetColorU32(hovered ? palette().accent : palette().line), 48,
                   1.5F * context.scale);
  drawArrow(canvas, dial.centre, tipOf(dial, context.settings.step.air.wind), context.scale,
            ImGui::GetColorU32(palette().accent));
}

void setHorizontalWind(PanelContext& context, const Vec3& wind) {
  changeSetting(context, settings::requireSetting("wind.x"), wind.x());
  changeSetting(context, settings::requireSetting("wind.z"), wind.z());
}

void dragDial(PanelContext& context, const Dial& dial) {
  if (ImGui::IsItemActive()) {
    const ImVec2 mouse = ImGui::GetMousePos();
    setHorizontalWind(context, windFromDial({static_cast<double>((mouse.x - dial.centre.x) / dial.radius),
                                             static_cast<double>((mouse.y - dial.centre.y) / dial.radius)}));
  } else if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    const Vec3& now = context.settings.step.air.wind;
    const Vec3& ofScene = context.sceneSettings.step.air.wind;
    const bool isOfScene = now.x() == ofScene.x() && now.z() == ofScene.z();
    setHorizontalWind(context, isOfScene ? Vec3(Vec3::Zero()) : ofScene);
  }
}

}  // namespace

void windDial(PanelContext& context) {
  const float side = std::round(ImGui::GetFontSize() * 5.4F);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Dial dial{{corner.x + side * 0.5F, corner.y + side * 0.5F}, side * 0.5F - 2.0F * context.scale};
  ImGui::InvisibleButton("dial", {side, side});
  context.buttons["wind.dial"] = lastItemRect();
  dragDial(context, dial);
  drawDial(context, dial, ImGui::IsItemHovered() || ImGui::IsItemActive());
  explainItem(context, "wind.dial",
              "The wind from above: x to the right, z towards you. Drag to change its direction and speed, "
              "right-click for the scene's wind, and again for none. The inner ring is 5 m/s, the outer ring 20 m/s.");
  ImGui::SameLine(0.0F, ImGui::GetFontSize());
  ImGui::BeginGroup();
  const Vec3& wind = context.settings.step.air.wind;
  mutedText(context.texts("Wind from above"));
  valueRow(context, "Speed", text::formatQuantity(wind.norm(), "m/s"));
  valueRow(context, "Level", text::formatQuantity(std::hypot(wind.x(), wind.z()), "m/s"));
  valueRow(context, "Upwards", text::formatQuantity(wind.y(), "m/s"));
  ImGui::EndGroup();
}

}  // namespace drape::ui
