#include "app/headless/picture_maker.hpp"

#include "render/osmesa_context.hpp"
#include "render/renderer.hpp"
#include "ui/user_interface.hpp"

#include <optional>

namespace drape {

struct PictureMaker::Parts {
  OsmesaContext context;
  Renderer renderer;
  std::optional<UserInterface> panels;
  Camera camera;
  Snapshot snapshot;
  int width = 0;
  int height = 0;
};

PictureMaker::PictureMaker(int width, int height, bool panels, double fontScale, const CameraPose& pose)
    : parts_(std::make_unique<Parts>()) {
  parts_->camera = Camera(pose);
  parts_->width = width;
  parts_->height = height;
  if (panels) {
    parts_->panels.emplace(UiDisplay{width, height, 1.0F, uiScale(fontScale, 1.0F, height)},
                           UserInterface::Backend::OpenGl);
  }
}

PictureMaker::~PictureMaker() = default;

Image PictureMaker::draw(const Simulation& simulation) {
  simulation.capture(parts_->snapshot);
  return parts_->panels ? drawWithPanels() : drawPlain(parts_->camera);
}

Image PictureMaker::drawPlain(const Camera& camera) {
  parts_->renderer.draw(parts_->snapshot, camera, parts_->width, parts_->height);
  return parts_->renderer.read();
}

Image PictureMaker::drawWithPanels() {
  UserInterface& panels = *parts_->panels;
  UiOutput ignored;  // there is no user
  const UiStats stats;
  // The layout needs three frames: first the width of the column, then the line breaks beside the scroll bar.
  for (int frame = 0; frame < 3; ++frame) {
    panels.build(parts_->snapshot, stats, ignored);
  }
  const Camera camera = besidePanels(parts_->camera, panels.view(), parts_->width, parts_->height);
  parts_->renderer.draw(parts_->snapshot, camera, parts_->width, parts_->height);
  parts_->renderer.bindTarget();
  panels.renderDrawData();
  return parts_->renderer.read();
}

}  // namespace drape
