#pragma once

#include "render/gl_objects.hpp"

namespace drape {

/// What a picture is drawn into: colour and depth with up to four samples a pixel, and the picture with one sample that
/// it resolves to. Where the driver refuses so many samples there are fewer, down to no multisampling.
class Framebuffer {
 public:
  /// @param samples a pixel, at most; 0: no multisampling
  explicit Framebuffer(int samples = mostSamples) : samples_(samples) {}

  /// Makes room for that size [pixels] if it is another than before, and binds the multisampled part for drawing.
  void begin(int width, int height);

  /// Averages the samples into the picture.
  void resolve();

  /// Binds the picture itself for drawing.
  void bindResolved() const;

  /// Copies the picture into framebuffer 0, with its lower left corner there [pixels].
  void blitToWindow(int left, int bottom) const;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Samples a pixel, once `begin` has made room; 0: no multisampling.
  [[nodiscard]] int samples() const { return samples_; }

  /// More are refused by Mesa's renderer llvmpipe; softpipe refuses any.
  static constexpr int mostSamples = 4;

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

}  // namespace drape
