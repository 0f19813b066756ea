#pragma once

#include "ui/input_queue.hpp"
#include "ui/interaction_controller.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace drape::app {

/// Collects the events of a window and passes them on frame by frame, in order, to ImGui and to take(). Fast events are
/// spread over several frames, so that no short tap is lost.
class WindowEvents {
 public:
  /// Input events, dropped files, and a click on the button that closes the window.
  struct Batch {
    std::vector<ui::InputEvent> input;
    std::vector<std::string> droppedFiles;
    bool closes = false;
    bool uncovers = false;  ///< the window system has lost a part of the picture
  };

  /// Needs a UserInterface. Takes over the window's callbacks until destruction.
  explicit WindowEvents(GLFWwindow* window);
  WindowEvents(const WindowEvents&) = delete;
  WindowEvents& operator=(const WindowEvents&) = delete;
  ~WindowEvents();

  /// Passes the events of this frame and the elapsed time to ImGui. Call it before UserInterface::build().
  void beginFrame();

  /// The input of this frame, and the other events since the last call.
  [[nodiscard]] Batch take();

  /// Whether input waits for a later frame.
  [[nodiscard]] bool waiting() const { return !queue_.empty(); }

 private:
  static WindowEvents& of(GLFWwindow* window);
  void install();
  void installPointer();
  void installClose();
  void onMouseButton(int button, int action, int modifiers);
  void onKey(int key, int scancode, int action, int modifiers);
  void feed(const ui::RawMove& move);
  void feed(const ui::RawButton& button);
  void feed(const ui::RawScroll& scroll);
  void feed(const ui::RawKey& key);
  void feed(const ui::RawCharacter& character);
  void feed(const ui::RawFocus& focus);

  GLFWwindow* window_;
  ui::InputQueue queue_;
  std::optional<ui::RawMove> pointer_;  // last reported mouse position
  Batch batch_;
  Vec2 mouse_ = Vec2::Zero();          // after the events that were passed on [window units]
  std::array<bool, 5> buttonsDown_{};  // after the events that were passed on
};

}  // namespace drape::app
