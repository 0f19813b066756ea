#pragma once

#include "settings/settings.hpp"
#include "sim/model/cloth_model.hpp"

#include <memory>

namespace drape::scene {

/// The same cloth, elastic as the settings say: springs or a fabric. Warp is vertical in the rest shape, turned by
/// fabric.warp_angle about the normal of each triangle. Throws ClothModelError as fabric::withFabric does.
[[nodiscard]] std::shared_ptr<const sim::ClothModel> withElasticity(const sim::ClothModel& model,
                                                                    const settings::Settings& settings);

/// The same with the mass of the settings. A cloth of springs that stays one does not change.
[[nodiscard]] std::shared_ptr<const sim::ClothModel> withMaterial(const sim::ClothModel& model,
                                                                  const settings::Settings& settings);

}  // namespace drape::scene
