#pragma once

#include "render/gl_context.hpp"

#include <memory>

namespace drape {

/// An OpenGL 3.3 core context without a window and without a display: Mesa's off-screen renderer, on the processor.
/// Pictures are drawn into framebuffer objects; its own framebuffer is a few pixels that nobody looks at.
/// For programs that link drape_osmesa and do not link drape_window. Throws InputError when it cannot be made.
class OsmesaContext : public GlContext {
 public:
  OsmesaContext();
  ~OsmesaContext() override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace drape
