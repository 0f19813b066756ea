#pragma once

#include "fields/shown_field.hpp"
#include "render/renderer.hpp"
#include "ui/user_interface.hpp"

#include <utility>

namespace drape::app {

/// Draws the pictures of a film beside the window, in the OpenGL context of the window.
class FilmPainter {
 public:
  /// @param width, height of the pictures [pixels]
  /// @param turns whether the camera turns once around the cloth
  FilmPainter(render::Camera camera, int width, int height, bool turns)
      : camera_(std::move(camera)), width_(width), height_(height), turns_(turns) {}

  /// Draws a snapshot at that share of the film, 0 to 1, with the legend of its colour map. Call it between two frames
  /// of the window.
  [[nodiscard]] render::Image draw(const session::Snapshot& snapshot, double share, ui::UserInterface& panels);

 private:
  render::Renderer renderer_;  // of its own, since a renderer keeps data of one simulation
  fields::SnapshotFields fields_;
  fields::FieldDisplay display_;
  render::Camera camera_;
  int width_;
  int height_;
  bool turns_;
};

}  // namespace drape::app
