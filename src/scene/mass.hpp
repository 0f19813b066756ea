#pragma once

#include "settings/settings.hpp"
#include "sim/model/cloth_model.hpp"

namespace drape {

/// The mass distribution of the settings.
[[nodiscard]] MassLumping lumpingOf(const Settings& settings);

/// The mass of a cloth with that rest area [m^2] under the settings [kg].
[[nodiscard]] double totalMassOf(const Settings& settings, double restArea);

}  // namespace drape
