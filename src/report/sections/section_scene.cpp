#include "report/sections/section_scene.hpp"

#include "messages/error.hpp"
#include "settings/settings_table.hpp"

#include <variant>

namespace drape {

SceneDescription requireGrid(const std::string& name) {
  SceneDescription description = openScene(name);
  if (!std::holds_alternative<GridSource>(description.source)) {
    throw InputError("the report refines its cloth, so it needs a scene with a grid; " + name + " has a mesh file");
  }
  return description;
}

std::shared_ptr<const Scene> gridScene(const std::string& name, int resolution,
                                       const std::vector<std::string>& settings,
                                       const std::optional<PinSelection>& pins) {
  SceneDescription description = requireGrid(name);
  description.pins = pins.value_or(description.pins);
  description.settings.grid.resolution = resolution;
  // Without ground the cloth falls freely, so that only its own motion is compared.
  description.ground.reset();
  if (description.stand) {
    description.stand->body.reset();
  }
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
