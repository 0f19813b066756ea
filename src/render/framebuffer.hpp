#pragma once

#include "render/gl_objects.hpp"

namespace drape::render {

/// The target of a picture: colour and depth with up to four samples per pixel, and the resolved picture. When the
/// driver refuses that many samples, there are fewer, down to no multisampling.
class Framebuffer {
 public:
  /// @param samples maximum per pixel; 0: no multisampling
  explicit Framebuffer(int samples = maxSamples) : samples_(samples) {}

  /// Allocates this size [pixels] when it changed, and binds the multisampled part for drawing.
  void begin(int width, int height);

  /// Averages the samples into the resolved picture.
  void resolve();

  /// Binds the resolved picture for drawing.
  void bindResolved() const;

  /// Copies the resolved picture into framebuffer 0, with its lower left corner there [pixels].
  void blitToWindow(int left, int bottom) const;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Samples per pixel after `begin`; 0: no multisampling.
  [[nodiscard]] int samples() const { return samples_; }

  /// Mesa's renderer llvmpipe refuses more; softpipe refuses any.
  static constexpr int maxSamples = 4;

 private:
  void allocate();
  [[nodiscard]] bool allocateSamples();

  int samples_;
  int width_ = 0;
  int height_ = 0;
  GlFramebuffer multisampled_;
  GlRenderbuffer sampledColour_;
  GlRenderbuffer sampledDepth_;
  GlFramebuffer resolved_;
  GlRenderbuffer colour_;
};

}  // namespace drape::render
