#include "report/sections/section_scene.hpp"

#include "messages/error.hpp"
#include "settings/settings_table.hpp"

#include <utility>
#include <variant>

namespace drape::report::sections {
namespace {

/// Without ground and stand the cloth falls freely, so that only its own motion is compared.
std::shared_ptr<const scene::Scene> inTheAir(scene::SceneDescription description,
                                             const std::vector<std::string>& settings) {
  description.ground.reset();
  if (description.stand) {
    description.stand->body.reset();
  }
  for (const std::string& expression : settings) {
    settings::assignSettingExpression(description.settings, expression);
  }
  return scene::buildScene(description, description.settings);
}

}  // namespace

scene::SceneDescription requireGrid(const std::string& name) {
  scene::SceneDescription description = scene::openScene(name);
  if (!std::holds_alternative<scene::GridSource>(description.cloth().source)) {
    throw messages::InputError("the report refines its cloth, so it needs a scene with a grid; " + name +
                               " has a mesh file");
  }
  return description;
}

std::shared_ptr<const scene::Scene> gridScene(const std::string& name, int resolution,
                                              const std::vector<std::string>& settings,
                                              const std::optional<scene::PinSelection>& pins) {
  scene::SceneDescription description = requireGrid(name);
  if (pins) {
    description.cloth().pins = {*pins};
  }
  description.settings.grid.resolution = resolution;
  return inTheAir(std::move(description), settings);
}

std::shared_ptr<const scene::Scene> meshScene(const std::string& name, const std::vector<std::string>& settings,
                                              const scene::PinSelection& pins) {
  scene::SceneDescription description = scene::openScene(name);
  description.cloth().pins = {pins};
  description.bodies.clear();
  return inTheAir(std::move(description), settings);
}

settings::Settings changedSettings(const scene::Scene& scene, const std::vector<std::string>& settings) {
  settings::Settings changed = scene.settings;
  for (const std::string& expression : settings) {
    settings::assignSettingExpression(changed, expression);
  }
  settings::requireConsistent(changed);
  return changed;
}

}  // namespace drape::report::sections
