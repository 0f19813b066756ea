#include "render/gl_objects.hpp"

#include <fmt/core.h>
#include <stdexcept>
#include <string>

namespace drape::render {

#ifdef NDEBUG
void checkGl(const char* /*where*/) {}
#else
void checkGl(const char* where) {
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) {
    throw std::logic_error(fmt::format("OpenGL error {:#x} in {}", error, where));
  }
}
#endif

void requireCompleteFramebuffer(const char* what) {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error(fmt::format("the graphics driver refuses the framebuffer for {} ({:#x})", what, status));
  }
}

}  // namespace drape::render
