#pragma once

#include "scene/scene.hpp"
#include "scene/scene_file.hpp"
#include "session/simulation.hpp"
#include "settings/settings_table.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace drape::session::testing {

/// A built-in scene with these settings ("key=value") in place of its own.
inline std::shared_ptr<const scene::Scene> builtIn(const std::string& name,
                                                   const std::vector<std::string>& settings = {}) {
  scene::SceneDescription description = scene::openScene(name);
  for (const std::string& expression : settings) {
    settings::assignSettingExpression(description.settings, expression);
  }
  return scene::buildScene(description, description.settings);
}

/// A scene from the text of a scene file.
inline std::shared_ptr<const scene::Scene> sceneFrom(const std::string& text) {
  const scene::SceneDescription description =
      scene::parseScene(text, "test", "test.toml", std::filesystem::current_path());
  return scene::buildScene(description, description.settings);
}

/// The built-in grid at a small size.
inline std::shared_ptr<const scene::Scene> smallGrid(int resolution = 9, std::vector<std::string> settings = {}) {
  settings.insert(settings.begin(), "grid.resolution=" + std::to_string(resolution));
  return builtIn("grid", settings);
}

/// Takes that many steps.
inline void takeSteps(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) {
    simulation.step();
  }
}

}  // namespace drape::session::testing
