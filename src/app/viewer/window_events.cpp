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

namespace drape::app {
namespace {

std::optional<ui::MouseButton> mouseButton(int button) {
  switch (button) {
    case GLFW_MOUSE_BUTTON_LEFT:
      return ui::MouseButton::Left;
    case GLFW_MOUSE_BUTTON_MIDDLE:
      return ui::MouseButton::Middle;
    case GLFW_MOUSE_BUTTON_RIGHT:
      return ui::MouseButton::Right;
    default:
      return std::nullopt;
  }
}

/// Keys with the same position on all keyboards.
std::optional<ui::Key> fixedKey(int key) {
  static constexpr std::array<std::pair<int, ui::Key>, 17> keys{{
      {GLFW_KEY_SPACE, ui::Key::Space},
      {GLFW_KEY_ESCAPE, ui::Key::Escape},
      {GLFW_KEY_F1, ui::Key::Help},
      {GLFW_KEY_F5, ui::Key::F5},
      {GLFW_KEY_F6, ui::Key::F6},
      {GLFW_KEY_F7, ui::Key::F7},
      {GLFW_KEY_F8, ui::Key::F8},
      {GLFW_KEY_F12, ui::Key::F12},
      {GLFW_KEY_5, ui::Key::Five},
      {GLFW_KEY_KP_5, ui::Key::Five},
      {GLFW_KEY_KP_DECIMAL, ui::Key::Period},
      {GLFW_KEY_1, ui::Key::One},
      {GLFW_KEY_3, ui::Key::Three},
      {GLFW_KEY_7, ui::Key::Seven},
      {GLFW_KEY_KP_1, ui::Key::One},
      {GLFW_KEY_KP_3, ui::Key::Three},
      {GLFW_KEY_KP_7, ui::Key::Seven},
  }};
  for (const auto& [code, meaning] : keys) {
    if (code == key) {
      return meaning;
    }
  }
  return std::nullopt;
}

/// Letters follow the user's keyboard layout.
std::optional<ui::Key> letterKey(int key, int scancode, bool shift) {
  const char* name = glfwGetKeyName(key, scancode);
  const std::string_view text = name == nullptr ? std::string_view() : name;
  if (text.size() != 1) {
    return std::nullopt;
  }
  switch (std::tolower(static_cast<unsigned char>(text.front()))) {
    case '.':
      return ui::Key::Period;
    case ',':
      return ui::Key::Comma;
    case 'b':
      return ui::Key::B;
    case 'e':
      return ui::Key::E;
    case 'f':
      return ui::Key::F;
    case 'g':
      return ui::Key::G;
    case 'h':
      return ui::Key::H;
    case 'l':
      return ui::Key::L;
    case 'o':
      return ui::Key::O;
    case 'p':
      return ui::Key::P;
    case 'q':
      return ui::Key::Q;
    case 'r':
      return ui::Key::R;
    case 's':
      return ui::Key::S;
    case 't':
      return ui::Key::T;
    case 'w':
      return ui::Key::W;
    case 'y':
      return ui::Key::Y;
    case 'z':
      return ui::Key::Z;
    case '/':
      return shift ? ui::Key::Help : ui::Key::Slash;
    case '?':
      return ui::Key::Help;
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
  glfwSetWindowRefreshCallback(window_, nullptr);
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
                      [](GLFWwindow* window, unsigned int code) { of(window).queue_.push(ui::RawCharacter{code}); });
  glfwSetWindowFocusCallback(
      window_, [](GLFWwindow* window, int focused) { of(window).queue_.push(ui::RawFocus{focused == GLFW_TRUE}); });
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
    of(window).pointer_ = ui::RawMove{x, y};
    of(window).queue_.push(ui::RawMove{x, y});
  });
  glfwSetCursorEnterCallback(window_, ImGui_ImplGlfw_CursorEnterCallback);
  glfwSetScrollCallback(window_, [](GLFWwindow* window, double x, double y) {
    of(window).queue_.push(ui::RawScroll{x, y});
  });
}

/// The window stays open until the viewer has asked about changes. A minimised window comes back for that question.
void WindowEvents::installClose() {
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { of(window).batch_.uncovers = true; });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* window) {
    glfwSetWindowShouldClose(window, GLFW_FALSE);
    of(window).batch_.closes = true;
    if (glfwGetWindowAttrib(window, GLFW_ICONIFIED) == GLFW_TRUE) {
      glfwRestoreWindow(window);
    }
  });
}

void WindowEvents::onMouseButton(int button, int action, int modifiers) {
  ui::RawButton press{.button = button,
                      .down = action == GLFW_PRESS,
                      .shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                      .control = (modifiers & GLFW_MOD_CONTROL) != 0,
                      .time = glfwGetTime()};
  // The position at the time of the click. The current position may be another one.
  if (!pointer_) {
    pointer_ = ui::RawMove{};
    glfwGetCursorPos(window_, &pointer_->x, &pointer_->y);
  }
  press.x = pointer_->x;
  press.y = pointer_->y;
  queue_.push(press);
}

void WindowEvents::onKey(int key, int scancode, int action, int modifiers) {
  using Action = ui::RawKey::Action;
  queue_.push(ui::RawKey{.key = key,
                         .scancode = scancode,
                         .modifiers = modifiers,
                         .action = action == GLFW_PRESS     ? Action::Down
                                   : action == GLFW_RELEASE ? Action::Up
                                                            : Action::Repeat,
                         .edits = edits(key, modifiers)});
}

void WindowEvents::feed(const ui::RawMove& move) {
  mouse_ = {move.x, move.y};
  const bool control = glfwGetKey(window_, GLFW_KEY_LEFT_CONTROL) == GLFW_PRESS ||
                       glfwGetKey(window_, GLFW_KEY_RIGHT_CONTROL) == GLFW_PRESS;
  batch_.input.emplace_back(ui::MoveEvent{mouse_, control});
}

void WindowEvents::feed(const ui::RawButton& button) {
  mouse_ = {button.x, button.y};
  if (button.button >= 0 && button.button < static_cast<int>(buttonsDown_.size())) {
    buttonsDown_[button.button] = button.down;
  }
  const auto which = mouseButton(button.button);
  if (which && button.down) {
    batch_.input.emplace_back(ui::PressEvent{
        .button = *which, .position = mouse_, .shift = button.shift, .control = button.control, .time = button.time});
  } else if (which) {
    batch_.input.emplace_back(ui::ReleaseEvent{*which});
  }
}

void WindowEvents::feed(const ui::RawScroll& scroll) {
  ImGui_ImplGlfw_ScrollCallback(window_, scroll.right, scroll.up);
  batch_.input.emplace_back(ui::ScrollEvent{scroll.up});
}

void WindowEvents::feed(const ui::RawKey& key) {
  const bool repeated = key.action == ui::RawKey::Action::Repeat;
  if (!repeated) {
    const int action = key.action == ui::RawKey::Action::Down ? GLFW_PRESS : GLFW_RELEASE;
    ImGui_ImplGlfw_KeyCallback(window_, key.key, key.scancode, action, key.modifiers);
  }
  if (key.action == ui::RawKey::Action::Up) {
    return;
  }
  auto meaning = fixedKey(key.key);
  if (!meaning) {
    meaning = letterKey(key.key, key.scancode, (key.modifiers & GLFW_MOD_SHIFT) != 0);
  }
  if (meaning) {
    batch_.input.emplace_back(ui::KeyEvent{*meaning, repeated, (key.modifiers & GLFW_MOD_CONTROL) != 0,
                                           (key.modifiers & GLFW_MOD_SHIFT) != 0});
  }
}

void WindowEvents::feed(const ui::RawCharacter& character) {
  ImGui_ImplGlfw_CharCallback(window_, character.code);
}

void WindowEvents::feed(const ui::RawFocus& focus) {
  ImGui_ImplGlfw_WindowFocusCallback(window_, focus.focused ? GLFW_TRUE : GLFW_FALSE);
  if (!focus.focused) {
    batch_.input.emplace_back(ui::FocusLostEvent{});
  }
}

void WindowEvents::beginFrame() {
  bool clicked = false;
  for (const ui::RawEvent& event : queue_.takeFrame()) {
    std::visit([this](const auto& each) { feed(each); }, event);
    clicked = clicked || std::holds_alternative<ui::RawButton>(event);
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

}  // namespace drape::app
