#pragma once

#include "settings/settings.hpp"

#include <string>

namespace drape::settings {

/// The word of the method of self-collision that acts with the chosen solver: "off", "hash" or "exact", never "auto".
[[nodiscard]] std::string actingSelfCollision(const Settings& settings);

}  // namespace drape::settings
