#pragma once

#include "settings/settings.hpp"

namespace drape::scene {

/// The settings of a mesh that is opened without a scene: a cotton garment in still air, with self-collision and
/// damping. docs/guide/scenes.md explains the differences from the defaults.
[[nodiscard]] settings::Settings openedMeshSettings();

}  // namespace drape::scene
