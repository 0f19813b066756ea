#pragma once

#include "render/gl_objects.hpp"

namespace drape {

/// What a picture is drawn into: colour and depth with four samples a pixel, and the picture with one sample that it
/// resolves to.
class Framebuffer {
 public:
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

  /// More are refused by Mesa's software renderer.
  static constexpr int samples = 4;

 private:
  void allocate();

  int width_ = 0;
  int height_ = 0;
  GlFramebuffer multisampled_;
  GlRenderbuffer sampledColour_;
  GlRenderbuffer sampledDepth_;
  GlFramebuffer resolved_;
  GlRenderbuffer colour_;
};

}  // namespace drape
