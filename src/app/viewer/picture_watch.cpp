#include "app/viewer/picture_watch.hpp"

#include <utility>

namespace drape::app {

PictureWatch::Parts PictureWatch::changed(ScenePicture scene, std::uint64_t panels) {
  Parts parts;
  parts.scene = panels_ == 0 || scene != scene_;
  parts.window = parts.scene || panels != panels_;
  scene_ = std::move(scene);
  panels_ = panels;
  return parts;
}

void PictureWatch::forget() {
  panels_ = 0;
}

}  // namespace drape::app
