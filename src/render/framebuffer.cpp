#include "render/framebuffer.hpp"

#include <algorithm>

namespace drape::render {

void Framebuffer::begin(int width, int height) {
  if (width != width_ || height != height_) {
    width_ = width;
    height_ = height;
    allocate();
  }
  glBindFramebuffer(GL_FRAMEBUFFER, multisampled_.name());
  glViewport(0, 0, width_, height_);
}

void Framebuffer::allocate() {
  while (!allocateSamples() && samples_ > 0) {
    samples_ = samples_ > 2 ? samples_ / 2 : 0;
  }
  requireCompleteFramebuffer("the picture's samples");
  glBindRenderbuffer(GL_RENDERBUFFER, colour_.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width_, height_);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.name());
  requireCompleteFramebuffer("the picture");
}

/// Binds the multisampled part with `samples_` samples per pixel; 0: none. False when the driver refuses.
bool Framebuffer::allocateSamples() {
  GLint maxSupported = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &maxSupported);
  samples_ = std::clamp(samples_, 0, std::max(maxSupported, 0));
  glBindRenderbuffer(GL_RENDERBUFFER, sampledColour_.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_RGBA8, width_, height_);
  glBindRenderbuffer(GL_RENDERBUFFER, sampledDepth_.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH_COMPONENT24, width_, height_);
  glBindFramebuffer(GL_FRAMEBUFFER, multisampled_.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, sampledColour_.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, sampledDepth_.name());
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void Framebuffer::resolve() {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, multisampled_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.name());
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  bindResolved();
}

void Framebuffer::bindResolved() const {
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
  glViewport(0, 0, width_, height_);
}

void Framebuffer::blitToWindow(int left, int bottom) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, width_, height_, left, bottom, left + width_, bottom + height_, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace drape::render
