#pragma once

#include "fabrics/presets.hpp"
#include "settings/settings.hpp"

namespace drape::render {

/// The look in which the cloth is drawn.
enum class Surface { Checker, Plain, Fabric };

/// The choice of view.surface, with the answer to "auto".
[[nodiscard]] Surface surfaceOf(const settings::Settings& settings);

/// The preset whose look the fabric in material.preset has. A changed preset keeps its look, and an own fabric has that
/// of its base. A custom one gets the look of the preset with the most similar values.
[[nodiscard]] const fabrics::Preset& lookedLike(const settings::Settings& settings);

/// Its look.
[[nodiscard]] const fabrics::Look& lookOf(const settings::Settings& settings);

}  // namespace drape::render
