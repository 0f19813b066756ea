#pragma once

#include "ui/input_queue.hpp"
#include "ui/interaction_controller.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace drape {

/// Collects what happens to a window, in order, and hands it out frame by frame: to ImGui and to take(). What happens
/// faster than frames are drawn is spread over several of them, so that no short tap is lost.
class WindowEvents {
 public:
  /// What may happen: input, files that are dropped on the window, or a click on the button that closes it.
  struct Batch {
    std::vector<InputEvent> input;
    std::vector<std::string> droppedFiles;
    bool closes = false;
  };

  /// Needs a UserInterface. Takes over the window's callbacks until destruction.
  explicit WindowEvents(GLFWwindow* window);
  WindowEvents(const WindowEvents&) = delete;
  WindowEvents& operator=(const WindowEvents&) = delete;
  ~WindowEvents();

  /// Tells ImGui what belongs to this frame, and the time that has passed; before UserInterface::build().
  void beginFrame();

  /// The input of this frame, and what else happened since the last call.
  [[nodiscard]] Batch take();

  /// True while input waits for a later frame.
  [[nodiscard]] bool waiting() const { return !queue_.empty(); }

 private:
  static WindowEvents& of(GLFWwindow* window);
  void install();
  void installPointer();
  void installClose();
  void onMouseButton(int button, int action, int modifiers);
  void onKey(int key, int scancode, int action, int modifiers);
  void feed(const RawMove& move);
  void feed(const RawButton& button);
  void feed(const RawScroll& scroll);
  void feed(const RawKey& key);
  void feed(const RawCharacter& character);
  void feed(const RawFocus& focus);

  GLFWwindow* window_;
  InputQueue queue_;
  std::optional<RawMove> pointer_;  // where the mouse was last reported to be
  Batch batch_;
  Vec2 mouse_ = Vec2::Zero();          // as of the events that were fed [window units]
  std::array<bool, 5> buttonsDown_{};  // as of the events that were fed
};

}  // namespace drape
