#include "report/sections/section_scene.hpp"

#include "settings/settings_table.hpp"
#include "sim/error.hpp"

#include <variant>

namespace drape {

std::shared_ptr<const Scene> gridScene(const std::string& name, int resolution,
                                       const std::vector<std::string>& settings) {
  SceneDescription description = openScene(name.empty() ? "grid" : name);
  if (!std::holds_alternative<GridSource>(description.source)) {
    throw InputError("the report refines its cloth, so it needs a scene with a grid; " + name + " has a mesh file");
  }
  description.settings.grid.resolution = resolution;
  for (const std::string& expression : settings) {
    assignSettingExpression(description.settings, expression);
  }
  return buildScene(description, description.settings);
}

Settings changedSettings(const Scene& scene, const std::vector<std::string>& settings) {
  Settings changed = scene.settings;
  for (const std::string& expression : settings) {
    assignSettingExpression(changed, expression);
  }
  requireConsistent(changed);
  return changed;
}

}  // namespace drape
