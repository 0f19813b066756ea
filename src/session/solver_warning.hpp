#pragma once

#include "settings/settings.hpp"
#include "sim/model/cloth_model.hpp"

#include <string>

namespace drape {

/// A warning in words when the chosen solver does not suit this cloth; empty otherwise.
[[nodiscard]] std::string solverWarning(const Settings& settings, const ClothModel& model);

/// The same for the ghost; empty without a ghost.
[[nodiscard]] std::string ghostWarning(const Settings& settings, const ClothModel& model);

}  // namespace drape
