#pragma once

#include "render/camera.hpp"
#include "render/image.hpp"
#include "session/simulation.hpp"

#include <memory>

namespace drape {

/// Draws simulations off screen, with or without the panels.
class PictureMaker {
 public:
  /// @param width, height [pixels]  @param panels draw the user interface beside the cloth
  /// @param fontScale of the panels; 0 chooses by the picture's height
  PictureMaker(int width, int height, bool panels, double fontScale, const CameraPose& pose);
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;
  ~PictureMaker();

  [[nodiscard]] Image draw(const Simulation& simulation);

 private:
  [[nodiscard]] Image drawPlain(const Camera& camera);
  [[nodiscard]] Image drawWithPanels();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace drape
