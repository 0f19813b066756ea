#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace drape {

/// A scene that is put together from several files. Either a scene or a cloth must be there.
struct SceneParts {
  std::string scene = {};                ///< a built-in scene, a scene file or a mesh file; empty: only what follows
  std::string cloth = {};                ///< a mesh file that is the cloth; empty: the scene's own
  std::vector<std::string> bodies = {};  ///< mesh files that the cloth meets, beside the scene's own bodies
};

/// Reads the parts and puts them together. A cloth takes the place of the scene's: its pins, pleats, stand and
/// placement go. Bodies are read as the cloth is, in the same unit and with the same axis up, and stay where their
/// files put them. Throws InputError as openScene does, and when there are too many bodies.
[[nodiscard]] SceneDescription openParts(const SceneParts& parts);

}  // namespace drape
