#pragma once

#include "app/headless/picture_maker.hpp"
#include "session/simulation.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace drape::app {

/// The arguments "[--resolution W,H] [--camera-position X,Y,Z] [--camera-focal-point X,Y,Z] [--orthographic] [--ui]" of
/// commands that draw.
struct ViewArguments {
  std::vector<int> resolution{1280, 720};
  std::vector<double> cameraPosition;
  std::vector<double> focalPoint;
  bool ui = false;
  bool orthographic = false;

  void addTo(CLI::App& app);
  /// Throws UsageError when the camera looks nowhere.
  [[nodiscard]] std::unique_ptr<PictureMaker> makerFor(const session::Simulation& simulation) const;
  /// All arguments in one line.
  [[nodiscard]] std::string inWords() const;
};

}  // namespace drape::app
