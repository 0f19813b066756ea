#include "render/gl_objects.hpp"

#include <sstream>
#include <stdexcept>
#include <string>

namespace drape {

#ifdef NDEBUG
void checkGl(const char* /*where*/) {}
#else
void checkGl(const char* where) {
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) {
    std::ostringstream message;
    message << "OpenGL error 0x" << std::hex << error << " in " << where;
    throw std::logic_error(message.str());
  }
}
#endif

void requireCompleteFramebuffer(const char* what) {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    std::ostringstream message;
    message << "the graphics driver refuses the framebuffer for " << what << " (0x" << std::hex << status << ")";
    throw std::runtime_error(message.str());
  }
}

}  // namespace drape
