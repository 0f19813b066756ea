#pragma once

#include "scene/cloth_part.hpp"
#include "settings/settings.hpp"
#include "sim/adaptive/step_choice.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <span>

namespace drape::app {

/// The choices of a solver such as `auto`; null for others.
/// @param cloths, settings those of the scene
[[nodiscard]] nlohmann::ordered_json toJson(const std::optional<sim::adaptive::StepChoice>& choice,
                                            std::span<const scene::ClothPart> cloths,
                                            const settings::Settings& settings);

}  // namespace drape::app
