#include "app/headless/picture_maker.hpp"

#include "fields/shown_field.hpp"
#include "render/osmesa_context.hpp"
#include "render/renderer.hpp"
#include "ui/user_interface.hpp"

#include <optional>

namespace drape::app {

struct PictureMaker::Parts {
  render::OsmesaContext context;
  render::Renderer renderer;
  std::optional<ui::UserInterface> panels;  // also for the legend of a colour map
  bool drawsPanels = false;
  fields::SnapshotFields fields;
  fields::FieldDisplay display;
  const fields::ShownField* field = nullptr;  // in the present picture
  render::Camera camera;
  session::Snapshot snapshot;
  int width = 0;
  int height = 0;
  double fontScale = 0.0;
};

PictureMaker::PictureMaker(int width, int height, bool panels, double fontScale, const render::Camera& camera)
    : parts_(std::make_unique<Parts>()) {
  parts_->camera = camera;
  parts_->width = width;
  parts_->height = height;
  parts_->drawsPanels = panels;
  parts_->fontScale = fontScale;
}

PictureMaker::~PictureMaker() = default;

render::Image PictureMaker::draw(const session::Simulation& simulation) {
  simulation.capture(parts_->snapshot);
  parts_->field = &parts_->display.update(parts_->snapshot, parts_->fields);
  return parts_->drawsPanels || parts_->field->field != nullptr ? drawWithPanels() : drawPlain(parts_->camera);
}

render::Image PictureMaker::drawPlain(const render::Camera& camera) {
  parts_->renderer.draw(parts_->snapshot, camera, parts_->width, parts_->height);
  return parts_->renderer.read();
}

render::Image PictureMaker::drawWithPanels() {
  if (!parts_->panels) {
    const float scale = ui::uiScale(parts_->fontScale, 1.0F, parts_->height);
    parts_->panels.emplace(ui::UiDisplay{parts_->width, parts_->height, 1.0F, scale},
                           ui::UserInterface::Backend::OpenGl);
    parts_->panels->showPanels(parts_->drawsPanels);
    parts_->panels->showNotices(parts_->drawsPanels);
  }
  ui::UserInterface& panels = *parts_->panels;
  ui::UiOutput ignored;  // there is no user
  ui::UiStats stats;
  stats.field = parts_->field;
  // The layout needs three frames: first the width of the column, then the line breaks beside the scroll bar.
  for (int frame = 0; frame < 3; ++frame) {
    panels.build(parts_->snapshot, stats, ignored);
  }
  const render::Camera camera = ui::besidePanels(parts_->camera, panels.view(), parts_->width, parts_->height);
  parts_->renderer.draw(parts_->snapshot, camera, parts_->width, parts_->height, {.field = parts_->field});
  parts_->renderer.bindTarget();
  panels.renderDrawData();
  return parts_->renderer.read();
}

}  // namespace drape::app
