// The rows of the section Scene for bodies whose files have several clips.
#include "scene/placements.hpp"
#include "ui/panels.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace drape::ui {
namespace {

/// Builds the scene again with another clip of a body.
void choose(PanelContext& context, std::size_t body, const std::string& clip) {
  scene::Placements choices = scene::placementsOf(context.snapshot.scene->description);
  choices.clips.at(body) = clip;
  context.output.requests.emplace_back(RebuildSceneRequest{context.settings, std::move(choices)});
}

void clipList(PanelContext& context, std::size_t body, const std::string& present, const std::string& key) {
  const std::vector<io::ClipFacts>& clips = context.snapshot.scene->clips[body];
  const auto shown = std::ranges::find(clips, present, &io::ClipFacts::name);
  const std::string title = shown == clips.end() ? present : clipName(*shown, context.texts);
  const float width = widthBesideArrow();
  if (!ImGui::BeginCombo("##clip", fitted(title, width).c_str(), ImGuiComboFlags_HeightLarge)) {
    return;
  }
  for (const io::ClipFacts& clip : clips) {
    ImGui::PushID(clip.name.c_str());
    if (ImGui::Selectable(clipName(clip, context.texts).c_str(), clip.name == present) && clip.name != present) {
      choose(context, body, clip.name);
    }
    context.buttons[key + "=" + clip.name] = lastItemRect();
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

void clipRow(PanelContext& context, std::size_t body) {
  const scene::BodyDescription& described = context.snapshot.scene->description.bodies[body];
  const std::string key = "body." + described.body.name + ".clip";
  const std::string& present = described.animation->clip;
  const std::string& opened = described.animation->openedClip;
  ImGui::PushID(key.c_str());
  const UiRect row = beginRow(context, "Motion", present != opened);
  ImGui::BeginDisabled(!context.stats.loading.empty());
  clipList(context, body, present, key);
  ImGui::EndDisabled();
  context.widgets[key] = lastItemRect();
  if (hoversRow(row)) {
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Right) && present != opened) {
      choose(context, body, opened);
    }
    explainItem(context, key, "The clip of the file that moves the body. The scene returns to its start.");
  }
  ImGui::PopID();
}

}  // namespace

void clipRows(PanelContext& context) {
  const scene::Scene& scene = *context.snapshot.scene;
  const auto hasChoice = [](const std::vector<io::ClipFacts>& clips) { return clips.size() > 1; };
  const auto count = std::ranges::count_if(scene.clips, hasChoice);
  for (std::size_t body = 0; body < scene.clips.size(); ++body) {
    if (!hasChoice(scene.clips[body])) {
      continue;
    }
    if (count > 1) {
      mutedText(scene.description.bodies[body].body.name);
    }
    clipRow(context, body);
  }
}

}  // namespace drape::ui
