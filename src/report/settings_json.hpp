#pragma once

#include "settings/settings.hpp"

#include <nlohmann/json.hpp>

namespace drape {

/// Every setting in force, by its key.
[[nodiscard]] nlohmann::ordered_json settingsJson(const Settings& settings);

}  // namespace drape
