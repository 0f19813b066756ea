#pragma once

#include "session/change_history.hpp"
#include "text/sentence.hpp"
#include "ui/ui_output.hpp"

#include <memory>

namespace drape::ui {

/// Undo and redo of settings, pins, bodies and placements in the window: passes the states of the snapshots on to a
/// session::ChangeHistory, and turns its steps into commands and requests.
class Undo {
 public:
  /// Another scene was opened.
  void forget() { history_.forget(); }

  /// Call it once a frame.
  /// @param inForce the settings with the user's latest changes  @param settled as for ChangeHistory::observe()
  /// @param now of any monotonic clock [s]
  void watch(const session::Snapshot& snapshot, const settings::Settings& inForce, bool settled, double now,
             UiOutput& output);

  /// Adds what takes back the last change to `output`. @return what it was, for the status line
  [[nodiscard]] text::Sentence undo(UiOutput& output);
  /// The same for the last change that was undone.
  [[nodiscard]] text::Sentence redo(UiOutput& output);

  /// Call it with all commands of the user.
  void noteCommands(const std::vector<session::Command>& commands);

  /// The present state of the user; call watch() before.
  [[nodiscard]] const session::UserState& present() const { return present_; }

 private:
  void request(const session::UserState& from, const session::UserState& to, UiOutput& output) const;
  void takePins(const session::Snapshot& snapshot);

  session::ChangeHistory history_;
  session::UserState present_;
  std::shared_ptr<const scene::Scene> scene_;
  std::shared_ptr<const sim::ClothModel> model_;  // of the pins of present_
  std::int64_t step_ = 0;
  double now_ = 0.0;
};

}  // namespace drape::ui
