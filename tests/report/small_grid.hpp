#pragma once

#include "scene/scene.hpp"
#include "settings/settings_table.hpp"

#include <initializer_list>
#include <memory>
#include <string>

namespace drape::testing {

/// The built-in grid with 5 x 5 vertices and these settings ("key=value").
inline std::shared_ptr<const Scene> smallGrid(std::initializer_list<std::string> settings = {}) {
  SceneDescription description = openScene("grid");
  description.settings.grid.resolution = 5;
  for (const std::string& expression : settings) {
    assignSettingExpression(description.settings, expression);
  }
  return buildScene(description, description.settings);
}

/// The scene's settings with these changes.
inline Settings with(const Scene& scene, std::initializer_list<std::string> settings) {
  Settings changed = scene.settings;
  for (const std::string& expression : settings) {
    assignSettingExpression(changed, expression);
  }
  return changed;
}

}  // namespace drape::testing
