#include "messages/error.hpp"
#include "settings/surface_fields.hpp"
#include "text/number_text.hpp"
#include "ui/number_slider.hpp"
#include "ui/panels.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <fmt/printf.h>
#include <algorithm>
#include <cmath>
#include <variant>

namespace drape::ui {
namespace {

std::string withUnit(const settings::SurfaceField& field, double value) {
  return fmt::sprintf(numberFormat("%.4g", field.unit), value);
}

SliderInput sliderOf(const std::string& key, const settings::SurfaceField& field) {
  const auto nearest = [&field](double value) -> settings::SettingValue {
    return std::clamp(value, field.min, field.max);
  };
  const auto typed = [&field, nearest](const std::string& text) {
    const auto number = text::parseNumber(text);
    if (!number || !std::isfinite(*number)) {
      throw messages::UsageError(std::string(field.key) + " must be a number, not '" + text + "'");
    }
    return nearest(*number);
  };
  const SliderRange range{field.min, field.sliderMax, field.logarithmic};
  return {key, range, numberFormat("%.4g", field.unit), nearest, typed};
}

void surfaceRow(PanelContext& context, std::size_t i, const settings::SurfaceField& field) {
  const sim::contact::Body& body = (*context.snapshot.scene->bodies)[i];
  const sim::contact::SurfaceProperties& surface = context.snapshot.bodies[i].surface;
  const double value = surface.*field.value;
  const double sceneValue = body.surface.*field.value;
  const auto change = [&](double changed) {
    context.output.commands.emplace_back(
        session::SetSurfaceCommand{static_cast<int>(i), settings::withSurfaceValue(surface, field, changed)});
  };
  const std::string key = "body." + body.name + "." + std::string(field.key);
  ImGui::PushID(key.c_str());
  const UiRect row =
      beginRow(context, text::Sentence::verbatim("  " + context.texts(field.title)), value != sceneValue);
  const Edit edit = numberSlider(context, sliderOf(key, field), value);
  context.widgets[key] = lastItemRect();
  if (edit.changed) {
    change(std::get<double>(edit.value));
  } else if (hoversRow(row) && ImGui::IsMouseClicked(ImGuiMouseButton_Right) && value != sceneValue) {
    change(sceneValue);
  }
  if (hoversRow(row) && hoveredLongEnough(context, key)) {
    beginExplanation(context, &row);
    ImGui::TextWrapped("%s", context.texts(field.help).c_str());
    ImGui::Spacing();
    mutedText(context.texts("Range: {} to {}", withUnit(field, field.min), withUnit(field, field.max)));
    mutedText(context.texts("In the scene: {}", withUnit(field, sceneValue)));
    mutedText(context.texts("Ctrl+click types a value. A right click restores the scene's value."));
    endExplanation();
  }
  ImGui::PopID();
}

/// The button beside a body's box, which opens and closes the rows of its surface.
void surfaceButton(PanelContext& context, const std::string& name) {
  const std::string word = context.texts("Surface");
  const float width = ImGui::CalcTextSize(word.c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  const bool open = context.memory.openSurface == name;
  ImGui::PushStyleColor(ImGuiCol_Button, open ? palette().accentFill : palette().field);
  if (ImGui::Button((word + "###surface").c_str())) {
    context.memory.openSurface = open ? "" : name;
  }
  ImGui::PopStyleColor();
  context.buttons["surface." + name] = lastItemRect();
  explainItem(context, "surface." + name, "Friction and thickness of this body.");
}

/// One check box per body of the scene, and the surface of one body.
void bodyRows(PanelContext& context) {
  const std::vector<sim::contact::Body>& bodies = *context.snapshot.scene->bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    beginRow(context, text::Sentence::verbatim(bodies[i].name));
    bool on = i < context.snapshot.bodies.size() && context.snapshot.bodies[i].on;
    if (ImGui::Checkbox("##body", &on)) {
      context.output.commands.emplace_back(session::SwitchBodyCommand{static_cast<int>(i), on});
    }
    context.buttons["body." + bodies[i].name] = lastItemRect();
    surfaceButton(context, bodies[i].name);
    for (const settings::SurfaceField& field : settings::surfaceFields()) {
      if (context.memory.openSurface == bodies[i].name && i < context.snapshot.bodies.size()) {
        surfaceRow(context, i, field);
      }
    }
    ImGui::PopID();
  }
}

void reportRows(PanelContext& context) {
  const sim::contact::ContactReport& contact = context.snapshot.stepReport.contact;
  valueRow(context, "Contacts with bodies", text::formatCount(contact.bodyContacts));
  valueRow(context, "Cost of bodies", text::formatDuration(contact.bodySeconds));
  if (contact.overlaps > 0) {
    valueRow(context, "Triangles inside a body", text::formatCount(contact.overlaps), palette().warning);
    valueRow(context, "Deepest", text::formatQuantity(contact.deepestOverlap * 1e3, "mm"), palette().warning);
  }
  if (contact.infeasible > 0) {
    valueRow(context, "Vertices between bodies", text::formatCount(contact.infeasible), palette().warning);
  }
}

void untangleButton(PanelContext& context) {
  if (ImGui::Button(labelOf(context, "Untangle", "untangle").c_str(), {ImGui::GetContentRegionAvail().x, 0.0F})) {
    context.output.commands.emplace_back(session::UntangleCommand{});
  }
  context.buttons["untangle"] = lastItemRect();
  explainItem(context, "untangle",
              "Moves the cloth until it no longer intersects itself, and brings it to rest there. Pins stay in place.");
}

/// The pairs with bodies, and the button that dresses the body.
void dressRows(PanelContext& context) {
  if (context.stats.piercing) {
    valueRow(context, "Triangle pairs with bodies",
             text::formatCount(static_cast<long long>(context.stats.piercing->pairs)), palette().warning);
  }
  if (!hasBodyToDress(context.snapshot)) {
    return;
  }
  if (ImGui::Button(labelOf(context, dressWord(context.snapshot), "dress").c_str(),
                    {ImGui::GetContentRegionAvail().x, 0.0F})) {
    context.output.requests.emplace_back(UiAction::Dress);
  }
  context.buttons["dress"] = lastItemRect();
  explainItem(context, "dress", dressHelp);
}

}  // namespace

bool hasBodyToDress(const session::Snapshot& snapshot) {
  const std::vector<sim::contact::Body>& bodies = *snapshot.scene->bodies;
  for (std::size_t i = 0; i < bodies.size() && i < snapshot.bodies.size(); ++i) {
    const bool hasInside = !std::holds_alternative<sim::contact::PlaneShape>(bodies[i].shape);
    if (hasInside && bodies[i].drawn && snapshot.bodies[i].on) {
      return true;
    }
  }
  return false;
}

const char* dressWord(const session::Snapshot& snapshot) {
  return snapshot.placedStart != nullptr || snapshot.step > 0 ? "Dress again" : "Dress";
}

int intersectingPairsOf(const session::Snapshot& snapshot) {
  return std::max(snapshot.stepReport.contact.intersections, static_cast<int>(snapshot.intersections.size()));
}

bool contactMatters(const PanelContext& context) {
  // Every scene has a ground. A ground or stand alone does not make contact the main subject of a scene.
  const std::vector<sim::contact::Body>& bodies = *context.snapshot.scene->bodies;
  return std::any_of(bodies.begin(), bodies.end(), [](const sim::contact::Body& body) { return body.drawn; }) ||
         context.settings.step.contact.self != sim::contact::SelfCollision::Off;
}

void contactRows(PanelContext& context) {
  if (context.settings.step.contact.self != sim::contact::SelfCollision::Off) {
    const sim::contact::ContactReport& contact = context.snapshot.stepReport.contact;
    valueRow(context, "Contacts with itself", text::formatCount(contact.selfContacts));
    valueRow(context, "Cost of self-collision", text::formatDuration(contact.selfSeconds));
    if (contact.crossings > 0) {
      valueRow(context, "Pairs that cross", text::formatCount(contact.crossings), palette().warning);
    }
  }
  if (const int pairs = intersectingPairsOf(context.snapshot); pairs > 0) {
    valueRow(context, "Triangle pairs that intersect", text::formatCount(pairs), palette().warning);
    untangleButton(context);
  }
  if (context.snapshot.scene->bodies->empty()) {
    mutedText(context.texts("There are no bodies in this scene."));
  } else {
    bodyRows(context);
    reportRows(context);
    dressRows(context);
  }
}

}  // namespace drape::ui
