#include "render/gl_context.hpp"

#include "messages/error.hpp"

#include <GL/glew.h>
#include <string>

namespace drape::render {

void loadGlFunctions(const char* label) {
  const std::string prefix = std::string(label) + ": ";
  // Without a version string the calls go to another OpenGL library than the one of the current context.
  const GLubyte* version = glGetString(GL_VERSION);
  if (version == nullptr) {
    throw messages::InputError(prefix + "the OpenGL context is not usable; another OpenGL library is loaded before it");
  }
  glewExperimental = GL_TRUE;
  glewInit();  // it reports an error without GLX, after it loaded everything
  if (!GLEW_VERSION_3_3) {
    throw messages::InputError(prefix + "OpenGL 3.3 is needed, but there is only " +
                               std::string(static_cast<const char*>(static_cast<const void*>(version))) +
                               "; a newer graphics driver may help");
  }
  while (glGetError() != GL_NO_ERROR) {
    // GLEW leaves errors behind in core contexts. Clear them.
  }
}

}  // namespace drape::render
