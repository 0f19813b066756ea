#pragma once

#include "settings/settings.hpp"

#include <nlohmann/json.hpp>

namespace drape::report {

/// All settings with their current values, by key.
[[nodiscard]] nlohmann::ordered_json settingsJson(const settings::Settings& settings);

}  // namespace drape::report
