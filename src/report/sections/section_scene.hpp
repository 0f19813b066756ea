#pragma once

#include "scene/scene.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drape::report::sections {

/// A built-in scene or scene file with a grid, with this number of vertices along its shorter side, these settings
/// ("key=value") in place of its own, and optionally other pins. Throws InputError when its cloth is not a grid.
[[nodiscard]] std::shared_ptr<const scene::Scene> gridScene(
    const std::string& name, int resolution, const std::vector<std::string>& settings,
    const std::optional<scene::PinSelection>& pins = std::nullopt);

/// A built-in scene or scene file with a mesh, without its bodies, with these settings and pins in place of its own.
[[nodiscard]] std::shared_ptr<const scene::Scene> meshScene(const std::string& name,
                                                            const std::vector<std::string>& settings,
                                                            const scene::PinSelection& pins);

/// Opens a scene. Throws InputError when there is none of that name or its cloth is not a grid.
scene::SceneDescription requireGrid(const std::string& name);

/// The scene's settings with these changes.
[[nodiscard]] settings::Settings changedSettings(const scene::Scene& scene, const std::vector<std::string>& settings);

}  // namespace drape::report::sections
