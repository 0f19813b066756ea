#pragma once

#include "scene/scene.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drape {

/// A built-in scene or scene file whose cloth is a grid, with so many vertices along its shorter side and these
/// settings ("key=value") in place of its own, and other pins if given. Throws InputError when its cloth is no grid.
[[nodiscard]] std::shared_ptr<const Scene> gridScene(const std::string& name, int resolution,
                                                     const std::vector<std::string>& settings,
                                                     const std::optional<PinSelection>& pins = std::nullopt);

/// Opens a scene; throws InputError when there is none of that name or its cloth is no grid.
SceneDescription requireGrid(const std::string& name);

/// The scene's settings with others in their place.
[[nodiscard]] Settings changedSettings(const Scene& scene, const std::vector<std::string>& settings);

}  // namespace drape
