#include "app/viewer/window_events.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <array>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>

namespace drape {
namespace {

std::optional<MouseButton> mouseButton(int button) {
  switch (button) {
    case GLFW_MOUSE_BUTTON_LEFT:
      return MouseButton::Left;
    case GLFW_MOUSE_BUTTON_MIDDLE:
      return MouseButton::Middle;
    case GLFW_MOUSE_BUTTON_RIGHT:
      return MouseButton::Right;
    default:
      return std::nullopt;
  }
}

/// Keys with the same position on all keyboards.
std::optional<Key> fixedKey(int key) {
  static constexpr std::array<std::pair<int, Key>, 11> keys{{
      {GLFW_KEY_SPACE, Key::Space},
      {GLFW_KEY_ESCAPE, Key::Escape},
      {GLFW_KEY_F1, Key::Help},
      {GLFW_KEY_F12, Key::F12},
      {GLFW_KEY_KP_DECIMAL, Key::Period},
      {GLFW_KEY_1, Key::One},
      {GLFW_KEY_3, Key::Three},
      {GLFW_KEY_7, Key::Seven},
      {GLFW_KEY_KP_1, Key::One},
      {GLFW_KEY_KP_3, Key::Three},
      {GLFW_KEY_KP_7, Key::Seven},
  }};
  for (const auto& [code, meaning] : keys) {
    if (code == key) {
      return meaning;
    }
  }
  return std::nullopt;
}

/// Letters follow the user's keyboard layout.
std::optional<Key> letterKey(int key, int scancode, bool shift) {
  const char* name = glfwGetKeyName(key, scancode);
  const std::string_view text = name == nullptr ? std::string_view() : name;
  if (text.size() != 1) {
    return std::nullopt;
  }
  switch (std::tolower(static_cast<unsigned char>(text.front()))) {
    case '.':
      return Key::Period;
    case 'f':
      return Key::F;
    case 'h':
      return Key::H;
    case 'p':
      return Key::P;
    case 'r':
      return Key::R;
    case 'w':
      return Key::W;
    case '/':
      return shift ? std::optional(Key::Help) : std::nullopt;
    case '?':
      return Key::Help;
    default:
      return std::nullopt;
  }
}

/// Keys that edit a text field. In GLFW the codes of keys without a letter begin with Escape.
bool edits(int key, int modifiers) {
  const bool modifier = key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
  return (key >= GLFW_KEY_ESCAPE && !modifier) || (modifiers & GLFW_MOD_CONTROL) != 0;
}

}  // namespace

WindowEvents::WindowEvents(GLFWwindow* window) : window_(window) {
  glfwSetWindowUserPointer(window, this);
  // ImGui's own callbacks are not installed; the queue feeds it.
  ImGui_ImplGlfw_InitForOpenGL(window, false);
  install();
  installPointer();
  installClose();
}

WindowEvents::~WindowEvents() {
  glfwSetMouseButtonCallback(window_, nullptr);
  glfwSetCursorPosCallback(window_, nullptr);
  glfwSetCursorEnterCallback(window_, nullptr);
  glfwSetScrollCallback(window_, nullptr);
  glfwSetKeyCallback(window_, nullptr);
  glfwSetCharCallback(window_, nullptr);
  glfwSetWindowFocusCallback(window_, nullptr);
  glfwSetDropCallback(window_, nullptr);
  glfwSetWindowCloseCallback(window_, nullptr);
  ImGui_ImplGlfw_Shutdown();
}

WindowEvents& WindowEvents::of(GLFWwindow* window) {
  return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
}

void WindowEvents::install() {
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    of(window).onKey(key, scancode, action, modifiers);
  });
  glfwSetCharCallback(window_,
                      [](GLFWwindow* window, unsigned int code) { of(window).queue_.push(RawCharacter{code}); });
  glfwSetWindowFocusCallback(
      window_, [](GLFWwindow* window, int focused) { of(window).queue_.push(RawFocus{focused == GLFW_TRUE}); });
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    for (int i = 0; i < count; ++i) {
      of(window).batch_.droppedFiles.emplace_back(paths[i]);
    }
  });
}

void WindowEvents::installPointer() {
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int modifiers) {
    of(window).onMouseButton(button, action, modifiers);
  });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
    of(window).pointer_ = RawMove{x, y};
    of(window).queue_.push(RawMove{x, y});
  });
  glfwSetCursorEnterCallback(window_, ImGui_ImplGlfw_CursorEnterCallback);
  glfwSetScrollCallback(window_, [](GLFWwindow* window, double x, double y) {
    of(window).queue_.push(RawScroll{x, y});
  });
}

/// The window stays open until the viewer has asked about changes. A minimised window comes back for that question.
void WindowEvents::installClose() {
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* window) {
    glfwSetWindowShouldClose(window, GLFW_FALSE);
    of(window).batch_.closes = true;
    if (glfwGetWindowAttrib(window, GLFW_ICONIFIED) == GLFW_TRUE) {
      glfwRestoreWindow(window);
    }
  });
}

void WindowEvents::onMouseButton(int button, int action, int modifiers) {
  RawButton press{.button = button,
                  .down = action == GLFW_PRESS,
                  .shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                  .control = (modifiers & GLFW_MOD_CONTROL) != 0,
                  .time = glfwGetTime()};
  // The position at the time of the click. The current position may be another one.
  if (!pointer_) {
    pointer_ = RawMove{};
    glfwGetCursorPos(window_, &pointer_->x, &pointer_->y);
  }
  press.x = pointer_->x;
  press.y = pointer_->y;
  queue_.push(press);
}

void WindowEvents::onKey(int key, int scancode, int action, int modifiers) {
  using Action = RawKey::Action;
  queue_.push(RawKey{.key = key,
                     .scancode = scancode,
                     .modifiers = modifiers,
                     .action = action == GLFW_PRESS     ? Action::Down
                               : action == GLFW_RELEASE ? Action::Up
                                                        : Action::Repeat,
                     .edits = edits(key, modifiers)});
}

void WindowEvents::feed(const RawMove& move) {
  mouse_ = {move.x, move.y};
  batch_.input.emplace_back(MoveEvent{mouse_});
}

void WindowEvents::feed(const RawButton& button) {
  mouse_ = {button.x, button.y};
  if (button.button >= 0 && button.button < static_cast<int>(buttonsDown_.size())) {
    buttonsDown_[button.button] = button.down;
  }
  const auto which = mouseButton(button.button);
  if (which && button.down) {
    batch_.input.emplace_back(PressEvent{
        .button = *which, .position = mouse_, .shift = button.shift, .control = button.control, .time = button.time});
  } else if (which) {
    batch_.input.emplace_back(ReleaseEvent{*which});
  }
}

void WindowEvents::feed(const RawScroll& scroll) {
  ImGui_ImplGlfw_ScrollCallback(window_, scroll.right, scroll.up);
  batch_.input.emplace_back(ScrollEvent{scroll.up});
}

void WindowEvents::feed(const RawKey& key) {
  const bool repeated = key.action == RawKey::Action::Repeat;
  if (!repeated) {
    const int action = key.action == RawKey::Action::Down ? GLFW_PRESS : GLFW_RELEASE;
    ImGui_ImplGlfw_KeyCallback(window_, key.key, key.scancode, action, key.modifiers);
  }
  if (key.action == RawKey::Action::Up) {
    return;
  }
  auto meaning = fixedKey(key.key);
  if (!meaning) {
    meaning = letterKey(key.key, key.scancode, (key.modifiers & GLFW_MOD_SHIFT) != 0);
  }
  if (meaning) {
    batch_.input.emplace_back(KeyEvent{*meaning, repeated});
  }
}

void WindowEvents::feed(const RawCharacter& character) {
  ImGui_ImplGlfw_CharCallback(window_, character.code);
}

void WindowEvents::feed(const RawFocus& focus) {
  ImGui_ImplGlfw_WindowFocusCallback(window_, focus.focused ? GLFW_TRUE : GLFW_FALSE);
  if (!focus.focused) {
    batch_.input.emplace_back(FocusLostEvent{});
  }
}

void WindowEvents::beginFrame() {
  bool clicked = false;
  for (const RawEvent& event : queue_.takeFrame()) {
    std::visit([this](const auto& each) { feed(each); }, event);
    clicked = clicked || std::holds_alternative<RawButton>(event);
  }
  ImGui_ImplGlfw_NewFrame();
  // The backend reads the current mouse state. Buttons and, while events wait, the position must be those of this
  // frame.
  ImGuiIO& io = ImGui::GetIO();
  for (std::size_t i = 0; i < buttonsDown_.size(); ++i) {
    io.MouseDown[i] = buttonsDown_[i];
  }
  if (clicked || waiting()) {
    io.MousePos = {static_cast<float>(mouse_.x()), static_cast<float>(mouse_.y())};
  }
}

WindowEvents::Batch WindowEvents::take() {
  return std::exchange(batch_, Batch{});
}

}  // namespace drape
