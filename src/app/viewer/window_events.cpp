#include "app/viewer/window_events.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>

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

/// Keys that are the same wherever letters are.
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

/// Letters are where the user's keyboard layout has them, not where an American keyboard would.
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

}  // namespace

WindowEvents::WindowEvents(GLFWwindow* window) : window_(window) {
  glfwSetWindowUserPointer(window, this);
  install();
  // ImGui chains to the callbacks that are there already, so it comes second.
  ImGui_ImplGlfw_InitForOpenGL(window, true);
}

WindowEvents::~WindowEvents() {
  ImGui_ImplGlfw_Shutdown();
  glfwSetCursorPosCallback(window_, nullptr);
  glfwSetDropCallback(window_, nullptr);
}

WindowEvents& WindowEvents::of(GLFWwindow* window) {
  return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
}

void WindowEvents::install() {
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int modifiers) {
    of(window).onMouseButton(button, action, modifiers);
  });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
    of(window).batch_.input.emplace_back(MoveEvent{{x, y}});
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* window, double /*x*/, double y) {
    of(window).batch_.input.emplace_back(ScrollEvent{y});
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    of(window).onKey(key, scancode, action, modifiers);
  });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int focused) {
    if (focused == GLFW_FALSE) {
      of(window).batch_.input.emplace_back(FocusLostEvent{});
    }
  });
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    for (int i = 0; i < count; ++i) {
      of(window).batch_.droppedFiles.emplace_back(paths[i]);
    }
  });
}

void WindowEvents::onMouseButton(int button, int action, int modifiers) {
  const auto which = mouseButton(button);
  if (!which) {
    return;
  }
  if (action == GLFW_RELEASE) {
    batch_.input.emplace_back(ReleaseEvent{*which});
    return;
  }
  PressEvent press{.button = *which,
                   .shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                   .control = (modifiers & GLFW_MOD_CONTROL) != 0,
                   .time = glfwGetTime()};
  glfwGetCursorPos(window_, &press.position.x(), &press.position.y());
  batch_.input.emplace_back(press);
}

void WindowEvents::onKey(int key, int scancode, int action, int modifiers) {
  if (action == GLFW_RELEASE) {
    return;
  }
  auto meaning = fixedKey(key);
  if (!meaning) {
    meaning = letterKey(key, scancode, (modifiers & GLFW_MOD_SHIFT) != 0);
  }
  if (meaning) {
    batch_.input.emplace_back(KeyEvent{*meaning, action == GLFW_REPEAT});
  }
}

void WindowEvents::beginFrame() {
  ImGui_ImplGlfw_NewFrame();
}

WindowEvents::Batch WindowEvents::take() {
  return std::exchange(batch_, Batch{});
}

}  // namespace drape
