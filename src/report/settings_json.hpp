#pragma once

#include "settings/settings.hpp"

#include <nlohmann/json.hpp>

namespace drape {

/// All settings with their current values, by key.
[[nodiscard]] nlohmann::ordered_json settingsJson(const Settings& settings);

}  // namespace drape
