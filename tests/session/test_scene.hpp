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

/// The text of a scene of two square sheets of cotton: the front one hangs from its upper corners, and the back one
/// faces away from it. More settings can follow.
/// @param lines keys of the back sheet, and tables
inline std::string twoSheets(const std::string& lines) {
  return R"(
[[cloths]]
name = "front"
grid = "vertical"
position = [0, 1, 0.1]
pins = { corners = ["top_left", "top_right"] }

[[cloths]]
name = "back"
grid = "vertical"
position = [0, 1, -0.1]
rotation = [0, 180, 0]
)" + lines +
         R"(

[settings]
grid.resolution = 9
grid.width = 0.4
grid.height = 0.4
material.model = "fabric"
material.preset = "cotton"
self_collision = "exact"
time_step = "1/300"
)";
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
