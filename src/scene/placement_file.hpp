#pragma once

#include "scene/placement.hpp"
#include "scene/toml_reader.hpp"
#include "scene/toml_text.hpp"

namespace drape::scene {

/// The key `placement` of a table that describes a cloth or a body. Throws InputError with the line of a wrong value.
[[nodiscard]] Placement readPlacement(const TomlReader& table);

/// Writes that key, unless the placement leaves everything where it is. Reads back to the same bits.
void writePlacement(const Placement& placement, TomlText& toml);

}  // namespace drape::scene
