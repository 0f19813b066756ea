#pragma once

#include "settings/settings.hpp"

#include <string>
#include <string_view>

namespace drape::app {

/// Replaces each setting in braces by its value: "{stiffness}.obj" becomes "100.obj". Other words in braces stay.
/// Characters that file names cannot have become "_".
[[nodiscard]] std::string withSettings(std::string_view pattern, const settings::Settings& settings);

/// Replaces "{cloth}" by a name.
[[nodiscard]] std::string withCloth(std::string pattern, std::string_view name);

}  // namespace drape::app
