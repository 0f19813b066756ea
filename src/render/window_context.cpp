#include "render/window_context.hpp"

#include "messages/error.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace drape::render {
namespace {

/// A message with GLFW's reason and a remedy.
std::string windowMessage(const std::string& what) {
  const char* reason = nullptr;
  glfwGetError(&reason);
  return what + (reason != nullptr ? std::string(": ") + reason : std::string()) +
         ". The viewer needs a desktop with OpenGL 3.3; without one, drape-headless draws into files";
}

GLFWwindow* openWindow(const std::string& title, int width, int height) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SAMPLES, 0);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  return glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
}

}  // namespace

WindowContext::WindowContext(const std::string& title, int width, int height) {
  if (glfwInit() != GLFW_TRUE) {
    throw messages::InputError(windowMessage("cannot reach a display"));
  }
  window_ = openWindow(title, width, height);
  if (window_ == nullptr) {
    // Get the reason before GLFW terminates.
    const std::string message = windowMessage("cannot open a window");
    glfwTerminate();
    throw messages::InputError(message);
  }
  glfwMakeContextCurrent(window_);
  try {
    loadGlFunctions("the window");
  } catch (const messages::InputError&) {
    glfwTerminate();
    throw;
  }
}

WindowContext::~WindowContext() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

}  // namespace drape::render
