#pragma once

#include "session/user_state.hpp"

#include <cstddef>
#include <deque>
#include <optional>

namespace drape::session {

/// The earlier states of the user's settings, pins and bodies, for undo and redo. It watches the states that the
/// snapshots show, so it knows every change, whatever caused it. All changes between two calls of observe() that are
/// settled become one step: one drag of a slider, one fabric, "Reset all".
class ChangeHistory {
 public:
  /// A step that was undone or redone: the state before it and the one after it.
  struct Step {
    UserState before;
    UserState after;
  };

  /// Another scene is running. Nothing of the previous one can be undone.
  void forget();

  /// Notes the present state.
  /// @param settled false while the user still drags or types, and while a scene is built
  /// @param now of any monotonic clock [s]
  /// @return the state that an undo or redo should have reached by now, but has not: the caller sends its changes
  /// again. Building a scene restores the pins of the file, and some values exclude each other until others are set.
  [[nodiscard]] std::optional<UserState> observe(const UserState& present, bool settled, double now);

  /// Takes back the last step. Empty if there is none. The caller sends the changes from `after` to `before`.
  [[nodiscard]] std::optional<Step> undo(const UserState& present, double now);
  /// Repeats the last step that was undone. Empty if there is none. The caller sends the changes from `before` to
  /// `after`.
  [[nodiscard]] std::optional<Step> redo(const UserState& present, double now);

  /// The user changes something while an undo is under way, so its changes must not be sent again.
  void stopWaiting() { awaited_ = false; }

  [[nodiscard]] std::size_t undoCount() const { return past_.size(); }
  [[nodiscard]] std::size_t redoCount() const { return future_.size(); }

  static constexpr std::size_t capacity = 200;  ///< number of steps that can be undone

 private:
  void record(const UserState& present);
  void await(const UserState& state, double now);

  std::deque<UserState> past_;      // oldest first
  std::deque<UserState> future_;    // the next one last
  std::optional<UserState> state_;  // after the last step
  bool awaited_ = false;            // whether an undo or redo has set state_, which no snapshot has shown yet
  int attempts_ = 0;                // how often its changes were sent
  double since_ = 0.0;              // when they were sent last [s]
};

}  // namespace drape::session
