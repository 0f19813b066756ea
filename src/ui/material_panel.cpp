#include "messages/error.hpp"
#include "scene/cloth_material.hpp"
#include "scene/rest_pattern.hpp"
#include "sim/fabric/fabric.hpp"
#include "ui/panels.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <imgui_stdlib.h>

#include <algorithm>

namespace drape::ui {
namespace {

using Place = SaveFabricRequest::Place;

float buttonWidth(const PanelContext& context, const char* word) {
  return ImGui::CalcTextSize(context.texts(word).c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
}

bool smallButton(PanelContext& context, const std::string& name, const char* word, const Wording& help) {
  const bool pressed = ImGui::Button(labelOf(context, word, name).c_str());
  context.buttons["button." + name] = lastItemRect();
  explainItem(context, "button." + name, help);
  return pressed;
}

/// Whether the running scene comes from a scene file of the user.
bool hasSceneFile(const PanelContext& context) {
  return context.snapshot.scene->description.parts.scene.ends_with(".toml");
}

void requestSave(PanelContext& context, Place place) {
  settings::OwnFabric fabric = settings::fabricOf(context.settings, context.memory.fabricName);
  try {
    settings::requireAllowed(fabric);
  } catch (const messages::UsageError& error) {
    context.output.hint = text::Sentence("The fabric is not saved: {}", error.what());
    return;
  }
  context.output.requests.emplace_back(SaveFabricRequest{std::move(fabric), place});
  context.memory.fabricName.clear();
}

/// Where warp comes from, and the triangles whose stiffness is clamped.
void fabricRows(PanelContext& context) {
  const session::Snapshot& snapshot = context.snapshot;
  if (snapshot.scene->cloths.size() > 1) {
    factRow(context, "Cloths", context.texts(scene::fabricsInWords(snapshot.scene->cloths, context.settings)));
  }
  factRow(context, "Warp", context.texts(scene::warpInWords(snapshot.scene->cloths, context.settings)));
  if (const text::Sentence note = scene::warpNote(snapshot.scene->cloths, context.settings); !note.empty()) {
    mutedText(context.texts("Note: {}.", note), palette().warning);
  }
  if (snapshot.model->fabric && snapshot.model->fabric->meshStrain) {
    factRow(
        context, "Rest shape",
        context.texts(scene::restShapeInWords(*snapshot.model, snapshot.scene->cloths.front().uvs, context.settings)));
    if (const text::Sentence note =
            scene::restShapeNote(*snapshot.model, snapshot.scene->cloths.front().uvs, context.settings);
        !note.empty()) {
      mutedText(context.texts("Warning: {}.", note), palette().warning);
    }
  }
  if (snapshot.model->fabric && snapshot.model->fabric->slivers > 0) {
    factRow(
        context, "Slivers",
        context.texts("{} of {} triangles have a lowered stiffness", text::formatCount(snapshot.model->fabric->slivers),
                      text::formatCount(static_cast<int>(snapshot.model->triangles.size()))));
  }
}

/// A field for a name, and buttons that save the fabric under it.
void saveFabricRow(PanelContext& context) {
  std::string& name = context.memory.fabricName;
  const bool known = settings::findOwnFabric(context.settings.fabric.own, name) != nullptr;
  const char* save = known ? "Replace" : "Save";
  const char* intoScene = "In scene";
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  beginRow(context, "Save fabric as");
  float buttons = std::max(buttonWidth(context, "Replace"), buttonWidth(context, "Save")) + gap;
  if (hasSceneFile(context)) {
    buttons += buttonWidth(context, intoScene) + gap;
  }
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - buttons);
  const bool entered =
      ImGui::InputTextWithHint("##fabric", context.texts("name").c_str(), &name, ImGuiInputTextFlags_EnterReturnsTrue);
  context.buttons["fabric.name"] = lastItemRect();
  explainItem(context, "fabric.name",
              "Saves the present values of the fabric under a name. The list of fabrics above then has it.");
  ImGui::SameLine(0.0F, gap);
  if (smallButton(context, "save_fabric", save, "Saves the fabric in your own list, for all scenes.") || entered) {
    requestSave(context, Place::List);
  }
  if (hasSceneFile(context)) {
    ImGui::SameLine(0.0F, gap);
    if (smallButton(context, "save_fabric_in_scene", intoScene,
                    text::Sentence("Saves the fabric in the file {}, so that it travels with the scene.",
                                   context.snapshot.scene->description.parts.scene))) {
      requestSave(context, Place::Scene);
    }
  }
}

}  // namespace

void materialRows(PanelContext& context) {
  const sim::ClothModel& model = *context.snapshot.model;
  const double mass = model.totalMass();
  const double area = model.restArea();
  if (settings::weighsAsFabric(context.settings) || context.settings.material.massGivenAs == "density") {
    valueRow(context, "Mass of the cloth", text::formatQuantity(mass, "kg"));
  } else if (area > 0.0) {
    valueRow(context, "Density", text::formatQuantity(mass / area, "kg/m\u00B2"));
  }
  if (settings::usesFabric(context.settings)) {
    fabricRows(context);
    saveFabricRow(context);
  }
}

}  // namespace drape::ui
