#include "ui/panels.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <imgui_stdlib.h>

namespace drape::ui {
namespace {

void openField(PanelContext& context) {
  std::string& path = context.memory.openPath;
  beginRow(context, "Open a file");
  const float button = ImGui::CalcTextSize("Open").x + 2.0F * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemInnerSpacing.x);
  const bool entered = ImGui::InputTextWithHint("##path", "path", &path, ImGuiInputTextFlags_EnterReturnsTrue);
  context.buttons["scene.path"] = lastItemRect();
  explainItem(context, "scene.path",
              "A scene (.toml) or a mesh (.obj and others). Files can also be dropped on the window.");
  ImGui::SameLine(0.0F, ImGui::GetStyle().ItemInnerSpacing.x);
  const bool pressed = ImGui::Button("Open");
  context.buttons["button.open"] = lastItemRect();
  if ((entered || pressed) && !path.empty()) {
    context.output.requests.emplace_back(OpenSceneRequest{path});
  }
}

}  // namespace

void sceneRows(PanelContext& context) {
  openField(context);
  if (!context.snapshot.scene->description.help.empty()) {
    mutedText(context.snapshot.scene->description.help);
  }
}

void meshRows(PanelContext& context) {
  const io::MeshSummary& summary = context.snapshot.scene->summary;
  ImGui::Dummy({0.0F, 2.0F * context.scale});
  for (const std::string& line : io::describe(summary)) {
    const std::size_t colon = line.find(':');
    const std::size_t value = colon == std::string::npos ? colon : line.find_first_not_of(' ', colon + 1);
    if (value == std::string::npos) {
      mutedText(line);
    } else {
      factRow(context, line.substr(0, colon), line.substr(value));
    }
  }
  factRow(context, "pinned", text::formatCount(countPins(*context.snapshot.model)) + " vertices");
  for (const std::string& warning : summary.warnings) {
    mutedText(warning, palette().warning);
  }
}

}  // namespace drape::ui
