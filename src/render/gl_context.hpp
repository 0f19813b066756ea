#pragma once

#include <memory>

namespace drape::render {

/// An OpenGL 3.3 core context that is current on this thread. This interface hides its origin (a window or OSMesa);
/// GLEW is loaded with it. Throws InputError with the reason when there is no such context.
class GlContext {
 public:
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;
};

/// Loads the OpenGL functions through GLEW and checks for version 3.3. `label` names the context in errors. GLEW's
/// return value is unreliable outside GLX, so the version decides.
void loadGlFunctions(const char* label);

}  // namespace drape::render
