#pragma once

#include <deque>
#include <variant>
#include <vector>

namespace drape {

/// What a window system reports, in its own codes. Positions in window units, times in seconds.
struct RawMove {
  double x = 0.0;
  double y = 0.0;
};
struct RawButton {
  int button = 0;
  bool down = false;
  bool shift = false;
  bool control = false;
  double x = 0.0;  ///< where the mouse was
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
  bool edits = false;  ///< acts on a text field by itself: Return, an arrow, Ctrl and a letter
};
struct RawCharacter {
  unsigned int code = 0;  ///< Unicode
};
struct RawFocus {
  bool focused = true;
};

using RawEvent = std::variant<RawMove, RawButton, RawScroll, RawKey, RawCharacter, RawFocus>;

/// Spreads events over frames. ImGui sees keys and buttons as states, once a frame: a key that goes down and comes up
/// between two frames would never have been pressed. So what ImGui could not tell apart goes to the next frame, in
/// order: a second change of a key or a button, a second editing key, text after an editing key, a move after a click.
class InputQueue {
 public:
  void push(const RawEvent& event) { waiting_.push_back(event); }

  /// The events of the next frame, in the order in which they came. Those that are left follow in later frames.
  [[nodiscard]] std::vector<RawEvent> takeFrame();

  /// True while events wait for a later frame.
  [[nodiscard]] bool empty() const { return waiting_.empty(); }

 private:
  std::deque<RawEvent> waiting_;
};

}  // namespace drape
