#pragma once

#include <deque>
#include <variant>
#include <vector>

namespace drape::ui {

/// Raw events of the window system, in its own codes. Positions in window units, times in seconds.
struct RawMove {
  double x = 0.0;
  double y = 0.0;
};
struct RawButton {
  int button = 0;
  bool down = false;
  bool shift = false;
  bool control = false;
  double x = 0.0;  ///< mouse position
  double y = 0.0;
  double time = 0.0;
};
struct RawScroll {
  double right = 0.0;
  double up = 0.0;
};
struct RawKey {
  enum class Action { Down, Up, Repeat };
  int key = 0;
  int scancode = 0;
  int modifiers = 0;
  Action action = Action::Down;
  bool edits = false;  ///< an editing key of a text field: Return, an arrow, Ctrl with a letter
};
struct RawCharacter {
  unsigned int code = 0;  ///< Unicode
};
struct RawFocus {
  bool focused = true;
};

using RawEvent = std::variant<RawMove, RawButton, RawScroll, RawKey, RawCharacter, RawFocus>;

/// Distributes events over frames. ImGui reads keys and buttons as states once per frame, so it would miss a key that
/// goes down and up between two frames. Events that ImGui could not tell apart move to the next frame, in order: a
/// second change of a key or a button, a second editing key, text after an editing key, a move after a click.
class InputQueue {
 public:
  void push(const RawEvent& event) { waiting_.push_back(event); }

  /// The events of the next frame, in order. The rest follow in later frames.
  [[nodiscard]] std::vector<RawEvent> takeFrame();

  /// Whether no event waits for a later frame.
  [[nodiscard]] bool empty() const { return waiting_.empty(); }

 private:
  std::deque<RawEvent> waiting_;
};

}  // namespace drape::ui
