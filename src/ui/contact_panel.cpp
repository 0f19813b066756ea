#include "settings/surface_fields.hpp"
#include "sim/error.hpp"
#include "text/number_text.hpp"
#include "ui/number_slider.hpp"
#include "ui/panels.hpp"
#include "ui/setting_widget.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <fmt/printf.h>
#include <algorithm>
#include <cmath>

namespace drape {
namespace {

std::string withUnit(const SurfaceField& field, double value) {
  return fmt::sprintf(numberFormat("%.4g", field.unit), value);
}

NumberInput inputOf(const std::string& key, const SurfaceField& field) {
  const auto nearest = [&field](double value) -> SettingValue { return std::clamp(value, field.min, field.max); };
  const auto typed = [&field, nearest](const std::string& text) {
    const auto number = parseNumber(text);
    if (!number || !std::isfinite(*number)) {
      throw UsageError(std::string(field.key) + " must be a number, not '" + text + "'");
    }
    return nearest(*number);
  };
  return {key, nearest, typed};
}

/// Static friction is never less than kinetic friction: changing one also moves the other.
void changeSurface(PanelContext& context, int body, SurfaceProperties surface, const SurfaceField& field,
                   double value) {
  surface.*field.value = value;
  if (field.value == &SurfaceProperties::staticFriction) {
    surface.kineticFriction = std::min(surface.kineticFriction, value);
  } else if (field.value == &SurfaceProperties::kineticFriction) {
    surface.staticFriction = std::max(surface.staticFriction, value);
  }
  context.output.commands.emplace_back(SetSurfaceCommand{body, surface});
}

void surfaceRow(PanelContext& context, int body, const SurfaceField& field) {
  const auto at = static_cast<std::size_t>(body);
  const Body& own = (*context.snapshot.scene->bodies)[at];
  const SurfaceProperties& surface = context.snapshot.bodies[at].surface;
  const double value = surface.*field.value;
  const double usual = own.surface.*field.value;
  const std::string key = "body." + own.name + "." + std::string(field.key);
  ImGui::PushID(key.c_str());
  const UiRect row = beginRow(context, "  " + std::string(field.title), value != usual);
  const SliderRange range{field.min, field.everyday, field.logarithmic};
  const Edit edit = numberSlider(context, inputOf(key, field), range, value, numberFormat("%.4g", field.unit));
  context.widgets[key] = lastItemRect();
  if (edit.changed) {
    changeSurface(context, body, surface, field, std::get<double>(edit.value));
  } else if (hoversRow(row) && ImGui::IsMouseClicked(ImGuiMouseButton_Right) && value != usual) {
    changeSurface(context, body, surface, field, usual);
  }
  if (hoversRow(row) && hoveredLongEnough(context, key)) {
    beginExplanation(context, &row);
    ImGui::TextWrapped("%.*s", static_cast<int>(field.help.size()), field.help.data());
    ImGui::Spacing();
    mutedText("Range: " + withUnit(field, field.min) + " to " + withUnit(field, field.max));
    mutedText("In the scene: " + withUnit(field, usual));
    mutedText("Ctrl+click types a value. A right click restores the scene's value.");
    endExplanation();
  }
  ImGui::PopID();
}

/// The button beside a body's box, which opens and closes the rows of its surface.
void surfaceButton(PanelContext& context, const std::string& name) {
  constexpr const char* word = "Surface";
  const float width = ImGui::CalcTextSize(word).x + 2.0F * ImGui::GetStyle().FramePadding.x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  const bool open = context.memory.openSurface == name;
  ImGui::PushStyleColor(ImGuiCol_Button, open ? palette().accentFill : palette().field);
  if (ImGui::Button(word)) {
    context.memory.openSurface = open ? "" : name;
  }
  ImGui::PopStyleColor();
  context.buttons["surface." + name] = lastItemRect();
  explainItem(context, "surface." + name, "Friction and thickness of this body.");
}

/// One check box per body of the scene, and the surface of one body.
void bodyRows(PanelContext& context) {
  const std::vector<Body>& bodies = *context.snapshot.scene->bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    beginRow(context, bodies[i].name);
    bool on = i < context.snapshot.bodies.size() && context.snapshot.bodies[i].on;
    if (ImGui::Checkbox("##body", &on)) {
      context.output.commands.emplace_back(SwitchBodyCommand{static_cast<int>(i), on});
    }
    context.buttons["body." + bodies[i].name] = lastItemRect();
    surfaceButton(context, bodies[i].name);
    for (const SurfaceField& field : surfaceFields()) {
      if (context.memory.openSurface == bodies[i].name && i < context.snapshot.bodies.size()) {
        surfaceRow(context, static_cast<int>(i), field);
      }
    }
    ImGui::PopID();
  }
}

void reportRows(PanelContext& context) {
  const ContactReport& contact = context.snapshot.stepReport.contact;
  valueRow(context, "Contacts with bodies", formatCount(contact.bodyContacts));
  valueRow(context, "Cost of bodies", formatDuration(contact.bodySeconds));
  if (contact.overlaps > 0) {
    valueRow(context, "Triangles inside a body", formatCount(contact.overlaps), palette().warning);
    valueRow(context, "Deepest", formatQuantity(contact.deepestOverlap * 1e3, "mm"), palette().warning);
  }
  if (contact.infeasible > 0) {
    valueRow(context, "Vertices between bodies", formatCount(contact.infeasible), palette().warning);
  }
}

}  // namespace

void contactPanel(PanelContext& context) {
  const std::vector<Body>& all = *context.snapshot.scene->bodies;
  const bool bodies = !all.empty();
  // Every scene has a ground. A ground or stand alone does not make contact the main subject of a scene.
  const bool ownBodies = std::any_of(all.begin(), all.end(), [](const Body& body) { return body.drawn; });
  const bool self = context.settings.step.contact.self != SelfCollision::Off;
  if (!beginSection(context, "Contact", ownBodies || self)) {
    return;
  }
  settingsOfGroup(context, SettingGroup::Contact);
  if (self) {
    const ContactReport& contact = context.snapshot.stepReport.contact;
    valueRow(context, "Contacts with itself", formatCount(contact.selfContacts));
    valueRow(context, "Cost of self-collision", formatDuration(contact.selfSeconds));
  }
  if (!bodies) {
    mutedText("There are no bodies in this scene.");
  } else {
    bodyRows(context);
    reportRows(context);
  }
  endSection();
}

}  // namespace drape
