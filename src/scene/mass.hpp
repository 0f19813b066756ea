#pragma once

#include "settings/settings.hpp"
#include "sim/model/cloth_model.hpp"

namespace drape::scene {

/// The mass distribution of the settings.
[[nodiscard]] sim::MassLumping lumpingOf(const settings::Settings& settings);

/// The mass of a cloth with that rest area [m^2] under the settings [kg].
[[nodiscard]] double totalMassOf(const settings::Settings& settings, double restArea);

}  // namespace drape::scene
