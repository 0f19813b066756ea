#pragma once

#include "scene/scene.hpp"
#include "settings/settings_table.hpp"

#include <initializer_list>
#include <memory>
#include <string>

namespace drape::report::testing {

/// The built-in grid with 5 x 5 vertices and these settings ("key=value").
inline std::shared_ptr<const scene::Scene> smallGrid(std::initializer_list<std::string> settings = {}) {
  scene::SceneDescription description = scene::openScene("grid");
  description.settings.grid.resolution = 5;
  for (const std::string& expression : settings) {
    settings::assignSettingExpression(description.settings, expression);
  }
  return scene::buildScene(description, description.settings);
}

/// The scene's settings with these changes.
inline settings::Settings with(const scene::Scene& scene, std::initializer_list<std::string> settings) {
  settings::Settings changed = scene.settings;
  for (const std::string& expression : settings) {
    settings::assignSettingExpression(changed, expression);
  }
  return changed;
}

}  // namespace drape::report::testing
