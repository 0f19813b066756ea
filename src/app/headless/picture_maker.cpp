#include "app/headless/picture_maker.hpp"

#include "render/osmesa_context.hpp"
#include "render/renderer.hpp"

namespace drape {

struct PictureMaker::Parts {
  OsmesaContext context;
  Renderer renderer;
  Camera camera;
  Snapshot snapshot;
  int width = 0;
  int height = 0;
};

PictureMaker::PictureMaker(int width, int height, bool panels, const CameraPose& pose)
    : parts_(std::make_unique<Parts>()) {
  static_cast<void>(panels);
  parts_->camera = Camera(pose);
  parts_->width = width;
  parts_->height = height;
}

PictureMaker::~PictureMaker() = default;

Image PictureMaker::draw(const Simulation& simulation) {
  simulation.capture(parts_->snapshot);
  parts_->renderer.draw(parts_->snapshot, parts_->camera, parts_->width, parts_->height);
  return parts_->renderer.read();
}

}  // namespace drape
