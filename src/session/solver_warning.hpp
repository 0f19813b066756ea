#pragma once

#include "settings/settings.hpp"
#include "sim/cloth_model.hpp"

#include <string>

namespace drape {

/// What is wrong with the chosen solver on this cloth, in words; empty when nothing is.
[[nodiscard]] std::string solverWarning(const Settings& settings, const ClothModel& model);

/// The same for the ghost's; empty when there is no ghost.
[[nodiscard]] std::string ghostWarning(const Settings& settings, const ClothModel& model);

}  // namespace drape
