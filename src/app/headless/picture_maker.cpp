#include "app/headless/picture_maker.hpp"

#include "render/osmesa_context.hpp"
#include "render/renderer.hpp"
#include "ui/user_interface.hpp"

#include <optional>

namespace drape::app {

struct PictureMaker::Parts {
  render::OsmesaContext context;
  render::Renderer renderer;
  std::optional<ui::UserInterface> panels;
  render::Camera camera;
  session::Snapshot snapshot;
  int width = 0;
  int height = 0;
};

PictureMaker::PictureMaker(int width, int height, bool panels, double fontScale, const scene::CameraPose& pose)
    : parts_(std::make_unique<Parts>()) {
  parts_->camera = render::Camera(pose);
  parts_->width = width;
  parts_->height = height;
  if (panels) {
    parts_->panels.emplace(ui::UiDisplay{width, height, 1.0F, ui::uiScale(fontScale, 1.0F, height)},
                           ui::UserInterface::Backend::OpenGl);
  }
}

PictureMaker::~PictureMaker() = default;

render::Image PictureMaker::draw(const session::Simulation& simulation) {
  simulation.capture(parts_->snapshot);
  return parts_->panels ? drawWithPanels() : drawPlain(parts_->camera);
}

render::Image PictureMaker::drawPlain(const render::Camera& camera) {
  parts_->renderer.draw(parts_->snapshot, camera, parts_->width, parts_->height);
  return parts_->renderer.read();
}

render::Image PictureMaker::drawWithPanels() {
  ui::UserInterface& panels = *parts_->panels;
  ui::UiOutput ignored;  // there is no user
  const ui::UiStats stats;
  // The layout needs three frames: first the width of the column, then the line breaks beside the scroll bar.
  for (int frame = 0; frame < 3; ++frame) {
    panels.build(parts_->snapshot, stats, ignored);
  }
  const render::Camera camera = ui::besidePanels(parts_->camera, panels.view(), parts_->width, parts_->height);
  parts_->renderer.draw(parts_->snapshot, camera, parts_->width, parts_->height);
  parts_->renderer.bindTarget();
  panels.renderDrawData();
  return parts_->renderer.read();
}

}  // namespace drape::app
