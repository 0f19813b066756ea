#pragma once

#include "render/gl_context.hpp"

#include <string>

struct GLFWwindow;

namespace drape::render {

/// A desktop window with an OpenGL 3.3 core context that is current on this thread. The window has no multisampling:
/// the renderer draws into its own framebuffer. Only one may exist, on the main thread. Throws InputError when there is
/// no display or no OpenGL 3.3.
class WindowContext : public GlContext {
 public:
  /// Width and height in screen coordinates.
  WindowContext(const std::string& title, int width, int height);
  ~WindowContext() override;

  /// For events, size and buffer swap. Valid as long as this object.
  [[nodiscard]] GLFWwindow* window() const { return window_; }

 private:
  GLFWwindow* window_ = nullptr;
};

}  // namespace drape::render
