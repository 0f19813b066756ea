#pragma once

#include "sim/step_choice.hpp"

#include <nlohmann/json.hpp>
#include <optional>

namespace drape {

/// What a solver that chooses for itself chose, in words and figures; null for others.
[[nodiscard]] nlohmann::ordered_json toJson(const std::optional<StepChoice>& choice);

}  // namespace drape
