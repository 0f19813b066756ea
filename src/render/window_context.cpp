#include "render/window_context.hpp"

#include "sim/error.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace drape {
namespace {

/// An error that says what GLFW said, and what to do.
InputError windowError(const std::string& what) {
  const char* reason = nullptr;
  glfwGetError(&reason);
  return InputError(what + (reason != nullptr ? std::string(": ") + reason : std::string()) +
                    ". The viewer needs a desktop with OpenGL 3.3; without one, drape-headless draws into files");
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
    throw windowError("cannot reach a display");
  }
  window_ = openWindow(title, width, height);
  if (window_ == nullptr) {
    const InputError error = windowError("cannot open a window");
    glfwTerminate();
    throw error;
  }
  glfwMakeContextCurrent(window_);
  try {
    loadGlFunctions("the window");
  } catch (const InputError&) {
    glfwTerminate();
    throw;
  }
}

WindowContext::~WindowContext() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

}  // namespace drape
