#pragma once

#include "scene/scene.hpp"
#include "scene/toml_reader.hpp"
#include "scene/toml_text.hpp"

namespace drape::scene {

/// Reads a table of [[seams]]. Whether its cloths and vertices exist is checked when the scene is built.
[[nodiscard]] SeamDescription readSeam(const TomlReader& reader);

/// Writes a table of [[seams]], which readSeam reads to the same seam.
void writeSeam(const SeamDescription& seam, TomlText& toml);

}  // namespace drape::scene
