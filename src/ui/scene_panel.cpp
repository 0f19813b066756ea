#include "io/mesh_summary.hpp"
#include "ui/panels.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <imgui_stdlib.h>

#include <algorithm>
#include <string>
#include <vector>

namespace drape::ui {
namespace {

/// A path with a button.
struct PathField {
  const char* title;
  const char* hint;
  const char* name;  ///< of the field, for tests
  const char* button;
  const char* explanation;
};

/// @return whether the user has confirmed the path
bool pathField(PanelContext& context, const PathField& field, std::string& path) {
  const UiRect row = beginRow(context, field.title);
  ImGui::PushID(field.name);
  if (context.memory.revealed.key == field.name && context.memory.revealed.isPending) {
    ImGui::SetKeyboardFocusHere();
  }
  const float button =
      ImGui::CalcTextSize(context.texts(field.button).c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemInnerSpacing.x);
  const bool entered = ImGui::InputTextWithHint("##path", context.texts(field.hint).c_str(), &path,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  context.buttons[field.name] = lastItemRect();
  explainItem(context, field.name, field.explanation);
  ImGui::SameLine(0.0F, ImGui::GetStyle().ItemInnerSpacing.x);
  const bool pressed = ImGui::Button(labelOf(context, field.button, "button").c_str());
  context.buttons[std::string(field.name) + ".button"] = lastItemRect();
  revealRow(context, field.name, row);
  ImGui::PopID();
  return entered || pressed;
}

void openField(PanelContext& context) {
  std::string& path = context.memory.openPath;
  if (pathField(context,
                {"Open a file", "path", "scene.path", "Open",
                 "A scene (.toml) or a mesh (.obj and others). Ctrl+O shows a dialog. Files can also be dropped on the "
                 "window."},
                path) &&
      !path.empty()) {
    context.output.requests.emplace_back(OpenSceneRequest{path});
  }
}

void saveField(PanelContext& context) {
  std::string& path = context.memory.savePath;
  if (pathField(context,
                {"Save cloth", "name.obj", "cloth.path", "Save",
                 "Writes the cloth as it is now to a new file: .obj, .ply, .glb, .usda and others. Without a name: an "
                 "OBJ in the current folder (E)."},
                path)) {
    context.output.requests.emplace_back(SaveClothRequest{path});
  }
}

void saveSceneField(PanelContext& context) {
  std::string& path = context.memory.scenePath;
  if (pathField(context,
                {"Save scene", "name.toml", "scene.save", "Save",
                 "Writes the scene to a new file, with the present settings, pins and bodies. It opens at the start of "
                 "the scene. Without a name: to the current folder (Ctrl+S)."},
                path)) {
    context.output.requests.emplace_back(SaveSceneRequest{path});
  }
}

/// The pinned vertices after a cloth was frozen. Without that it has the pins of the scene.
std::vector<int> pinsAfter(const session::Snapshot& snapshot, std::size_t index, bool isFrozen) {
  const scene::ClothPart& cloth = snapshot.scene->cloths[index];
  const bool hasPins = !snapshot.scene->description.cloths[index].frozen;
  std::vector<int> pins;
  for (int v = 0; v < snapshot.model->vertexCount(); ++v) {
    const bool isOfCloth = v >= cloth.firstVertex && v < cloth.firstVertex + cloth.vertexCount;
    const bool ofScene = hasPins && snapshot.scene->model->pinned[v];
    if (isOfCloth ? isFrozen || ofScene : snapshot.model->pinned[v]) {
      pins.push_back(v);
    }
  }
  return pins;
}

void frozenRow(PanelContext& context, std::size_t index) {
  const scene::ClothPart& cloth = context.snapshot.scene->cloths[index];
  const auto first = context.snapshot.model->pinned.begin() + cloth.firstVertex;
  bool isFrozen = std::all_of(first, first + cloth.vertexCount, [](bool pinned) { return pinned; });
  const std::string name = "frozen." + cloth.name;
  ImGui::PushID(name.c_str());
  beginRow(context, text::Sentence("Freeze {}", cloth.name));
  if (ImGui::Checkbox("##frozen", &isFrozen)) {
    context.output.commands.emplace_back(session::SetPinsCommand{pinsAfter(context.snapshot, index, isFrozen)});
  }
  context.buttons[name] = lastItemRect();
  explainItem(context, name, "No vertex of this cloth moves. The other cloths meet it as they meet a body.");
  ImGui::PopID();
}

/// One check box per cloth, if there are several.
void frozenRows(PanelContext& context) {
  const std::size_t count = context.snapshot.scene->cloths.size();
  for (std::size_t i = 0; count > 1 && i < count; ++i) {
    frozenRow(context, i);
  }
}

}  // namespace

void sceneRows(PanelContext& context) {
  openField(context);
  recentFilesRow(context);
  saveSceneField(context);
  saveField(context);
  if (!context.snapshot.scene->description.help.empty()) {
    mutedText(context.texts(context.snapshot.scene->description.help));
  }
  figureRows(context);
  clipRows(context);
}

void meshRows(PanelContext& context) {
  const io::MeshSummary& summary = context.snapshot.scene->summary;
  ImGui::Dummy({0.0F, 2.0F * context.scale});
  for (const io::MeshFact& fact : io::factsOf(summary)) {
    factRow(context, fact.title, context.texts(fact.value));
  }
  factRow(context, "pinned", context.texts("{} vertices", text::formatCount(countPins(*context.snapshot.model))));
  frozenRows(context);
  selectRow(context);
  placeRow(context);
  sewingRows(context);
  for (const std::string& warning : summary.warnings) {
    if (context.snapshot.seams->empty() || !warning.ends_with(io::piecesNeedPins)) {
      mutedText(warning, palette().warning);
    }
  }
}

}  // namespace drape::ui
