#pragma once

#include "scene/cloth_part.hpp"
#include "settings/settings.hpp"
#include "sim/model/cloth_model.hpp"

#include <memory>
#include <span>

namespace drape::scene {

/// The mass distribution of the settings.
[[nodiscard]] sim::MassLumping lumpingOf(const settings::Settings& settings);

/// The mass of a cloth with that rest area [m^2] under the settings [kg].
[[nodiscard]] double totalMassOf(const settings::Settings& settings, double restArea);

/// The same model with the masses that the settings give its cloths. Throws ClothModelError as sim::withMass does.
/// @param cloths of the model  @param settings of the scene
[[nodiscard]] std::shared_ptr<const sim::ClothModel> withMasses(const sim::ClothModel& model,
                                                                std::span<const ClothPart> cloths,
                                                                const settings::Settings& settings);

}  // namespace drape::scene
