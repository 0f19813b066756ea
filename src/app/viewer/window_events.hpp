#pragma once

#include "ui/interaction_controller.hpp"

#include <string>
#include <vector>

struct GLFWwindow;

namespace drape {

/// Collects what happens to a window between two frames, in order, and feeds ImGui.
class WindowEvents {
 public:
  /// What may happen: input, or files that are dropped on the window.
  struct Batch {
    std::vector<InputEvent> input;
    std::vector<std::string> droppedFiles;
  };

  /// Needs a UserInterface. Takes over the window's callbacks until destruction.
  explicit WindowEvents(GLFWwindow* window);
  WindowEvents(const WindowEvents&) = delete;
  WindowEvents& operator=(const WindowEvents&) = delete;
  ~WindowEvents();

  /// Tells ImGui about the mouse and the time that has passed; before UserInterface::build().
  void beginFrame();

  /// Everything since the last call.
  [[nodiscard]] Batch take();

 private:
  static WindowEvents& of(GLFWwindow* window);
  void install();
  void onMouseButton(int button, int action, int modifiers);
  void onKey(int key, int scancode, int action, int modifiers);

  GLFWwindow* window_;
  Batch batch_;
};

}  // namespace drape
