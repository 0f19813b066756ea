#pragma once

#include "scene/scene.hpp"
#include "settings/settings_table.hpp"

#include <string>
#include <vector>

namespace drape::testing {

/// The built-in grid at a small size, with these settings ("key=value") in place of its own.
inline std::shared_ptr<const Scene> smallGrid(int resolution = 9, const std::vector<std::string>& settings = {}) {
  SceneDescription description = openScene("grid");
  description.settings.grid.resolution = resolution;
  for (const std::string& expression : settings) {
    assignSettingExpression(description.settings, expression);
  }
  return buildScene(description, description.settings);
}

}  // namespace drape::testing
