#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace drape {

/// The files of a scene. Either `scene` or `cloth` must be set.
struct SceneParts {
  std::string scene = {};                ///< a built-in scene, a scene file or a mesh file; empty: only the next two
  std::string cloth = {};                ///< a mesh file for the cloth; empty: the cloth of the scene
  std::vector<std::string> bodies = {};  ///< mesh files of additional bodies
};

/// Reads the parts and combines them. A new cloth replaces that of the scene with its pins, pleats, stand and
/// placement. Bodies are read with the unit and the up axis of the cloth and keep the positions of their files. Throws
/// InputError like openScene, and for too many bodies.
[[nodiscard]] SceneDescription openParts(const SceneParts& parts);

}  // namespace drape
