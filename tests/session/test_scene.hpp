#pragma once

#include "scene/scene.hpp"

namespace drape::testing {

/// The built-in grid at a small size.
inline std::shared_ptr<const Scene> smallGrid(int resolution = 9) {
  SceneDescription description = openScene("grid");
  description.settings.grid.resolution = resolution;
  return buildScene(description, description.settings);
}

}  // namespace drape::testing
