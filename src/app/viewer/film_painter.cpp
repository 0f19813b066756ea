#include "app/viewer/film_painter.hpp"

#include <numbers>

namespace drape::app {

render::Image FilmPainter::draw(const session::Snapshot& snapshot, double share, ui::UserInterface& panels) {
  render::Camera camera = camera_;
  if (turns_) {
    camera.orbit(2.0 * std::numbers::pi * share, 0.0);
  }
  const fields::ShownField& field = display_.update(snapshot, fields_);
  renderer_.draw(snapshot, camera, width_, height_, {.field = &field});
  if (field.field != nullptr) {
    ui::UiStats stats;
    stats.field = &field;
    renderer_.bindTarget();
    panels.drawLegend(snapshot, stats, width_, height_);
  }
  return renderer_.read();
}

}  // namespace drape::app
