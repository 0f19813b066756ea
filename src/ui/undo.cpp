#include "ui/undo.hpp"

#include "ui/change_words.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace drape::ui {

/// Another model may have other pins, and a return to the start moves them.
void Undo::takePins(const session::Snapshot& snapshot) {
  if (snapshot.model != model_ || snapshot.step < step_) {
    present_.pins = session::pinsOf(snapshot);
    model_ = snapshot.model;
  }
  step_ = snapshot.step;
}

void Undo::watch(const session::Snapshot& snapshot, const settings::Settings& inForce, bool settled, double now,
                 UiOutput& output) {
  takePins(snapshot);
  present_ = session::userStateOf(snapshot, present_.pins);
  present_.settings = inForce;
  scene_ = snapshot.scene;
  now_ = now;
  if (const std::optional<session::UserState> missed = history_.observe(present_, settled, now)) {
    request(present_, *missed, output);
  }
}

text::Sentence Undo::undo(UiOutput& output) {
  const std::optional<session::ChangeHistory::Step> step = history_.undo(present_, now_);
  if (!step) {
    return text::Sentence("There is nothing to undo");
  }
  request(step->after, step->before, output);
  return text::Sentence("Undone: {}", changeInWords(step->before, step->after, *scene_));
}

text::Sentence Undo::redo(UiOutput& output) {
  const std::optional<session::ChangeHistory::Step> step = history_.redo(present_, now_);
  if (!step) {
    return text::Sentence("There is nothing to redo");
  }
  request(step->before, step->after, output);
  return text::Sentence("Redone: {}", changeInWords(step->before, step->after, *scene_));
}

void Undo::request(const session::UserState& from, const session::UserState& to, UiOutput& output) const {
  const auto changed = session::changedSettings(from.settings, to.settings);
  const bool places = from.placements != to.placements;
  const bool rebuilds = places || std::ranges::any_of(changed, [](const settings::SettingInfo* info) {
                          return info->effect == settings::SettingEffect::Scene;
                        });
  // Pins and bodies follow when the scene is built: its mesh may have other vertices, and it starts with its own pins.
  std::vector<session::Command> commands =
      rebuilds ? session::settingCommands(from.settings, to.settings) : session::commandsBetween(from, to, *scene_);
  std::ranges::move(commands, std::back_inserter(output.commands));
  if (rebuilds) {
    output.requests.emplace_back(
        RebuildSceneRequest{to.settings, places ? std::optional(to.placements) : std::nullopt});
  }
}

void Undo::noteCommands(const std::vector<session::Command>& commands) {
  if (std::ranges::any_of(commands, session::changesUserState)) {
    history_.stopWaiting();
  }
}

}  // namespace drape::ui
