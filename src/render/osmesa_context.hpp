#pragma once

#include "render/gl_context.hpp"

#include <memory>

namespace drape::render {

/// An OpenGL 3.3 core context without a window and without a display: Mesa's off-screen renderer, on the processor.
/// Pictures are drawn into framebuffer objects; its default framebuffer has a few unused pixels. For programs that link
/// drape_osmesa and not drape_window. Throws InputError when it cannot be created.
class OsmesaContext : public GlContext {
 public:
  OsmesaContext();
  ~OsmesaContext() override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace drape::render
