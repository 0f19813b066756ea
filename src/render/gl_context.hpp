#pragma once

#include <memory>

namespace drape {

/// An OpenGL 3.3 core context that is current on this thread. What makes it (a window, OSMesa, one day EGL) is behind
/// this interface; GLEW is loaded once it exists. Throws InputError when it cannot be had, saying why.
class GlContext {
 public:
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;
};

/// Loads the OpenGL functions through GLEW and checks that version 3.3 is there. `label` names the context in errors.
/// GLEW's own return value is no judge outside GLX, so the version is.
void loadGlFunctions(const char* label);

}  // namespace drape
