#pragma once

#include "settings/settings.hpp"

namespace drape {

/// The settings of a mesh that is opened without a scene: a garment of cotton in still air, that meets itself and comes
/// to rest. Where they differ from the table's defaults, docs/guide/scenes.md says why.
[[nodiscard]] Settings openedMeshSettings();

}  // namespace drape
