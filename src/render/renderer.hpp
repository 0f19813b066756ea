#pragma once

#include "fields/colour_map.hpp"
#include "fields/shown_field.hpp"
#include "render/camera.hpp"
#include "render/image.hpp"
#include "session/snapshot.hpp"

#include <memory>
#include <span>

namespace drape::render {

/// What a picture shows besides the snapshot.
struct PictureExtras {
  const fields::ShownField* field = nullptr;  ///< colours of the cloth; null: its own look
  std::span<const int> picked = {};           ///< vertices that get a mark, in the order of their colours
};

/// Draws snapshots: cloth (smooth, two-sided, checkered, plain or as its fabric), its ghost in green, stand, bodies,
/// ground, soft light with shadows, attachment, pins and contacts. Needs a current GlContext from construction to
/// destruction.
class Renderer {
 public:
  Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  ~Renderer();

  /// Draws into its own multisampled framebuffer of that size [pixels], resolves it, and leaves the result bound for
  /// blitToWindow() and read(). Uses snapshot.settings.view. The snapshot's scene, model and version tell what must be
  /// uploaded, so all snapshots of one renderer must come from one simulation.
  void draw(const session::Snapshot& snapshot, const Camera& camera, int width, int height,
            const PictureExtras& extras = {});

  /// Copies the last picture into framebuffer 0 (the window's), with its lower left corner there [pixels], and leaves
  /// that framebuffer bound.
  void blitToWindow(int left = 0, int bottom = 0);

  /// Binds the resolved framebuffer for drawing, so that panels can be drawn over the picture.
  void bindTarget();

  /// Reads the last picture.
  [[nodiscard]] Image read();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace drape::render
