#pragma once

#include "scene/scene.hpp"
#include "settings/settings_table.hpp"

#include <string>
#include <vector>

namespace drape::session::testing {

/// The built-in grid at a small size, with these settings ("key=value") in place of its own.
inline std::shared_ptr<const scene::Scene> smallGrid(int resolution = 9,
                                                     const std::vector<std::string>& settings = {}) {
  scene::SceneDescription description = scene::openScene("grid");
  description.settings.grid.resolution = resolution;
  for (const std::string& expression : settings) {
    settings::assignSettingExpression(description.settings, expression);
  }
  return scene::buildScene(description, description.settings);
}

}  // namespace drape::session::testing
