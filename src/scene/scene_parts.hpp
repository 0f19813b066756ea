#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace drape::scene {

/// Reads the parts and combines them. A new cloth replaces that of the scene with its pins, pleats, stand and
/// placement. Bodies are read with the unit and the up axis of the cloth and keep the positions of their files. Throws
/// InputError like openScene, and for too many bodies. @param own the user's fabrics
[[nodiscard]] SceneDescription openParts(const SceneParts& parts, const settings::OwnFabrics& own = {});

}  // namespace drape::scene
