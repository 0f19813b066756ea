#pragma once

#include "render/camera.hpp"
#include "render/image.hpp"
#include "session/simulation.hpp"

#include <memory>

namespace drape::app {

/// Draws simulations off screen, with or without the panels.
class PictureMaker {
 public:
  /// @param width, height [pixels]  @param panels draw the user interface beside the cloth
  /// @param fontScale of the panels; 0 chooses by the picture's height
  PictureMaker(int width, int height, bool panels, double fontScale, const render::Camera& camera);
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;
  ~PictureMaker();

  [[nodiscard]] render::Image draw(const session::Simulation& simulation);

 private:
  [[nodiscard]] render::Image drawPlain(const render::Camera& camera);
  [[nodiscard]] render::Image drawWithPanels();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace drape::app
