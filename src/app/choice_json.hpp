#pragma once

#include "sim/adaptive/step_choice.hpp"

#include <nlohmann/json.hpp>
#include <optional>

namespace drape::app {

/// The choices of a solver such as `auto`; null for others.
[[nodiscard]] nlohmann::ordered_json toJson(const std::optional<sim::adaptive::StepChoice>& choice);

}  // namespace drape::app
