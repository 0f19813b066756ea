#include "io/animation_import.hpp"
#include "scene/garment_on_body.hpp"
#include "ui/dropped_files.hpp"
#include "ui/panels.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace drape::ui {
namespace {

constexpr const char* explanation =
    "The other meshes become bodies that the cloth meets.\n"
    "Open leaves all where the files put it.\n"
    "Place puts the cloth on the body, where you move, turn and scale both before you dress.\n"
    "Dress puts the cloth on the body and removes all intersections.";

/// What the dialog shows.
struct DropView {
  const DroppedFiles& files;
  std::span<const FoundFile> found;
  std::vector<std::optional<scene::MeshReading>> readings;  ///< of the meshes
  std::vector<std::string> names;                           ///< of what can be the cloth
};

/// The names of what can be the cloth.
std::vector<std::string> namesOfChoices(const PanelContext& context, const DroppedFiles& files) {
  std::vector<std::string> choices = distinctNames(files.meshes);
  if (!files.scenes.empty()) {
    choices.push_back(context.texts("the cloth of {}", shortName(files.scenes.back())));
  }
  return choices;
}

const FoundFile* findFile(const DropView& shown, std::size_t mesh) {
  const auto file = std::ranges::find(shown.found, shown.files.meshes[mesh], &FoundFile::file);
  return file == shown.found.end() ? nullptr : &*file;
}

/// The lengths of the rows about a mesh [pixels].
struct DropLayout {
  float indent = 0.0F;
  float label = 0.0F;    ///< of the names of the rows
  float choices = 0.0F;  ///< of a unit
  float text = 0.0F;     ///< of what is right of the choices
  float width = 0.0F;    ///< of all
  float height = 0.0F;   ///< of all meshes
};

/// Of the sentences beside the choices, the widest one [pixels].
float widthOfReasons(const PanelContext& context, const DropView& shown, std::size_t cloth) {
  float widest = 0.0F;
  const auto take = [&](const text::Sentence& sentence) {
    widest = std::max(widest, ImGui::CalcTextSize(context.texts(sentence).c_str()).x);
  };
  for (std::size_t i = 0; i < shown.readings.size(); ++i) {
    const FoundFile* file = findFile(shown, i);
    if (shown.readings[i] && file != nullptr && file->mesh) {
      const io::MeshUse use = i == cloth ? io::MeshUse::Cloth : io::MeshUse::Body;
      take(scene::unitReasonInWords(*file->mesh, *shown.readings[i], use));
      take(scene::upReasonInWords(*shown.readings[i]));
    }
  }
  return widest;
}

DropLayout layoutOf(const PanelContext& context, const UiRect& view, const DropView& shown, std::size_t cloth) {
  const ImGuiStyle& style = ImGui::GetStyle();
  DropLayout layout;
  layout.indent = ImGui::GetFrameHeight() + style.ItemInnerSpacing.x;
  for (const char* label : {"Unit", "Up axis", "Motion"}) {
    layout.label = std::max(layout.label, ImGui::CalcTextSize(context.texts(label).c_str()).x + style.ItemSpacing.x);
  }
  layout.choices = 17.0F * ImGui::GetFontSize();
  float names = 0.0F;
  for (const std::string& name : shown.names) {
    names = std::max(names, ImGui::CalcTextSize(name.c_str()).x);
  }
  const float left = layout.indent + layout.label + layout.choices + style.ItemSpacing.x;
  const float below = ImGui::CalcTextSize(context.texts(explanation).c_str()).x;
  const float wanted = std::max({left + widthOfReasons(context, shown, cloth), layout.indent + names, below}) +
                       style.ScrollbarSize + 1.0F;
  // In a narrow window the dialog covers the panels, too.
  const float widest = ImGui::GetIO().DisplaySize.x - style.ScrollbarSize - 6.0F * style.WindowPadding.x;
  layout.width = std::min(wanted, widest);
  layout.text = std::max(0.0F, layout.width - style.ScrollbarSize - left);
  const float row = ImGui::GetFrameHeightWithSpacing();
  const float block = 3.0F * row + 2.0F * ImGui::GetTextLineHeightWithSpacing() + style.ItemSpacing.y;
  const auto meshes = static_cast<float>(shown.files.meshes.size());
  const auto moving = std::ranges::count_if(shown.found, [](const FoundFile& file) {
    return file.mesh && !file.mesh->isOnlyAnimation && !file.mesh->clips.empty();
  });
  const float all =
      block * meshes + row * (static_cast<float>(shown.names.size()) - meshes + static_cast<float>(moving));
  layout.height = std::min(all, std::max(2.0F * row, static_cast<float>(view.height) - 10.0F * row));
  return layout;
}

void choiceLabel(const PanelContext& context, const char* label, const DropLayout& layout) {
  const float start = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(context.texts(label).c_str());
  ImGui::SameLine(start + layout.label);
}

/// A sentence right of the choices, cut where the dialog ends.
void reasonText(const PanelContext& context, const text::Sentence& reason, float start, const DropLayout& layout) {
  ImGui::SameLine(start + layout.label + layout.choices + ImGui::GetStyle().ItemSpacing.x);
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, palette().muted);
  ImGui::TextUnformatted(fitted(context.texts(reason), layout.text).c_str());
  ImGui::PopStyleColor();
}

/// The choice of the clip that moves a body. @param present absent: the body stands
void motionRow(PanelContext& context, const scene::FoundMesh& mesh, const std::optional<std::string>& present,
               const std::string& name, const DropLayout& layout, MotionChoice& choice) {
  choiceLabel(context, "Motion", layout);
  const float width = layout.choices + layout.text;
  ImGui::SetNextItemWidth(width);
  const std::string still = context.texts("stands as it was modelled");
  const auto shown = std::ranges::find_if(mesh.clips, [&](const io::ClipFacts& clip) { return clip.name == present; });
  const std::string title = shown == mesh.clips.end() ? still : clipName(*shown, context.texts);
  const bool isOpen = ImGui::BeginCombo(("##" + name).c_str(), fitted(title, width).c_str());
  context.buttons[name] = lastItemRect();
  if (!isOpen) {
    return;
  }
  if (!mesh.isOnlyAnimation && ImGui::Selectable(still.c_str(), !present)) {
    choice = {true, std::nullopt};
  }
  for (std::size_t i = 0; i < mesh.clips.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable(clipName(mesh.clips[i], context.texts).c_str(), mesh.clips[i].name == present)) {
      choice = {true, mesh.clips[i].name};
    }
    context.buttons[name + "." + std::to_string(i)] = lastItemRect();
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

/// The choices of the unit and the up axis. @param isMoved a clip decides the up axis
void readingRows(PanelContext& context, const scene::FoundMesh& mesh, const scene::MeshReading& reading,
                 io::MeshUse use, const std::string& name, const DropLayout& layout, bool isMoved,
                 scene::ReadingChoice& choice) {
  const float start = ImGui::GetCursorPosX();
  choiceLabel(context, "Unit", layout);
  ImGui::SetNextItemWidth(layout.choices);
  if (const std::string unit = unitChoice(context, name + ".unit", reading.unit); unit != reading.unit) {
    choice.unit = unit;
  }
  reasonText(context, scene::unitReasonInWords(mesh, reading, use), start, layout);
  if (isMoved) {
    return;
  }
  choiceLabel(context, "Up axis", layout);
  ImGui::SetNextItemWidth(layout.choices);
  if (const std::string up = upChoice(context, name + ".up", reading.up); up != reading.up) {
    choice.up = up;
  }
  reasonText(context, scene::upReasonInWords(reading), start, layout);
}

/// What was found in a mesh, and the choices about it.
void factRows(PanelContext& context, const DropView& shown, const FoundFile& file, std::size_t i,
              const DropLayout& layout, DropChoices& choices) {
  const scene::MeshReading& reading = *shown.readings[i];
  mutedText(context.texts(scene::sizeInWords(reading)));
  mutedText(context.texts(scene::countsInWords(*file.mesh)));
  if (scene::isBuiltInWear(file.file)) {
    return;  // in metres with y up
  }
  const std::string name = "drop." + std::to_string(i);
  const std::optional<std::string> clip = clipBy(shown.files, choices, i, shown.found);
  const io::MeshUse use = i == choices.cloth ? io::MeshUse::Cloth : io::MeshUse::Body;
  if (use == io::MeshUse::Body && !file.mesh->clips.empty()) {
    motionRow(context, *file.mesh, clip, name + ".motion", layout, choices.motions[i]);
  }
  if (!file.mesh->isOnlyAnimation) {
    readingRows(context, *file.mesh, reading, use, name, layout, clip.has_value(), choices.readings[i]);
  }
}

void meshRows(PanelContext& context, const DropView& shown, std::size_t i, const DropLayout& layout,
              DropChoices& choices) {
  const ImVec2 top = ImGui::GetCursorPos();
  ImGui::Indent(layout.indent);
  const FoundFile* file = findFile(shown, i);
  if (file == nullptr || (!file->mesh && file->problem.empty()) || (file->mesh && !shown.readings[i])) {
    mutedText(context.texts("Reading the file \u2026"));
  } else if (!file->mesh) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette().warning);
    ImGui::TextWrapped("%s", context.texts(file->problem).c_str());
    ImGui::PopStyleColor();
  } else {
    factRows(context, shown, *file, i, layout, choices);
  }
  ImGui::Unindent(layout.indent);
  const float rows = 2.0F * (ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing());
  ImGui::SetCursorPos({top.x, std::max(ImGui::GetCursorPosY(), top.y + rows)});
  ImGui::Spacing();
}

void radioButton(PanelContext& context, const std::string& name, std::size_t i, const DropLayout& layout,
                 bool canBeCloth, DropChoices& choices) {
  ImGui::BeginDisabled(!canBeCloth);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1.5F * context.scale);
  ImGui::PushStyleColor(ImGuiCol_Border, palette().muted);
  const float room = layout.width - layout.indent - ImGui::GetStyle().ScrollbarSize;
  if (ImGui::RadioButton((fitted(name, room) + "###choice").c_str(), i == choices.cloth)) {
    choices.cloth = i;
  }
  context.buttons["cloth." + std::to_string(i)] = lastItemRect();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ImGui::EndDisabled();
}

/// What can be the cloth, in a box that scrolls when it does not all fit into the picture.
void clothChoice(PanelContext& context, const UiRect& view, const DropView& shown, DropChoices& choices) {
  const DropLayout layout = layoutOf(context, view, shown, choices.cloth);
  ImGui::BeginChild("choices", {layout.width, layout.height});
  for (std::size_t i = 0; i < shown.names.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const bool canBeCloth = i >= shown.files.meshes.size() || !io::isOnlyAnimationFile(shown.files.meshes[i]);
    radioButton(context, shown.names[i], i, layout, canBeCloth, choices);
    if (i < shown.files.meshes.size()) {
      meshRows(context, shown, i, layout, choices);
    }
    ImGui::PopID();
  }
  ImGui::EndChild();
}

/// Puts the next button beside the last one, if there is room for it.
void besideIfItFits(float width) {
  const ImGuiStyle& style = ImGui::GetStyle();
  if (ImGui::GetItemRectMax().x + 2.0F * style.ItemSpacing.x + width < ImGui::GetIO().DisplaySize.x) {
    ImGui::SameLine();
  }
}

/// How the user answers.
enum class DropAnswer { None, Open, Place, Dress, Alone, Cancel };

DropAnswer buttonsOf(PanelContext& context, const DroppedFiles& files) {
  float width = 118.0F * context.scale;
  for (const char* word : {"Open (Enter)", "Place", "Dress", "Cancel (Esc)"}) {
    width = widthOfButton(context, word, width);
  }
  DropAnswer answer = DropAnswer::None;
  const auto button = [&](const char* name, const Wording& word, DropAnswer meaning, bool strong = false) {
    if (meaning != DropAnswer::Open) {
      besideIfItFits(width);
    }
    if (iconButton(context, name, Icon::None, word, width, strong)) {
      answer = meaning;
    }
  };
  button("drop.open", "Open (Enter)", DropAnswer::Open, true);
  button("drop.place", "Place", DropAnswer::Place);
  button("drop.dress", "Dress", DropAnswer::Dress);
  if (!files.alone.empty() && !io::isOnlyAnimationFile(files.alone)) {
    button("drop.alone",
           text::Sentence::verbatim(fitted(context.texts("Only {}", shortName(files.alone)),
                                           width - 2.0F * ImGui::GetStyle().FramePadding.x)),
           DropAnswer::Alone);
  }
  button("drop.cancel", "Cancel (Esc)", DropAnswer::Cancel);
  const bool enter = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
                     ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
  return answer == DropAnswer::None && enter ? DropAnswer::Open : answer;
}

scene::SceneParts partsFor(DropAnswer answer, const DropView& shown, const DropChoices& choices) {
  const DroppedFiles& files = shown.files;
  if (answer == DropAnswer::Alone) {
    scene::SceneParts alone{.scene = files.alone};
    const auto mesh = std::ranges::find(files.meshes, files.alone);
    if (mesh != files.meshes.end()) {
      alone.clothReading = choices.readings.at(static_cast<std::size_t>(mesh - files.meshes.begin()));
    }
    return alone;
  }
  scene::SceneParts parts = partsBy(files, choices, shown.found);
  parts.dressed = answer != DropAnswer::Open;
  parts.placed = answer == DropAnswer::Place;
  return parts;
}

}  // namespace

bool dropQuestion(PanelContext& context, const UiRect& view, const DroppedFiles& files, DropChoices& choices) {
  const DropView shown{files, context.stats.found, readingsBy(files, choices, context.stats.found),
                       namesOfChoices(context, files)};
  beginDialog(context, view, "drop", "Which one is the cloth?");
  clothChoice(context, view, shown, choices);
  ImGui::Spacing();
  mutedText(context.texts(explanation));
  ImGui::Spacing();
  const DropAnswer answer = buttonsOf(context, files);
  if (answer != DropAnswer::None && answer != DropAnswer::Cancel) {
    context.output.requests.emplace_back(OpenPartsRequest{partsFor(answer, shown, choices)});
  }
  endDialog();
  return answer == DropAnswer::None;
}

}  // namespace drape::ui
