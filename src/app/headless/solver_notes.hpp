#pragma once

#include "settings/settings.hpp"
#include "sim/cloth_model.hpp"

namespace drape {

/// Tells on standard error what is wrong with the chosen solver, and with the ghost's, on this cloth.
void printSolverWarnings(const Settings& settings, const ClothModel& model);

}  // namespace drape
