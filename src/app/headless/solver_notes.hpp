#pragma once

#include "settings/settings.hpp"
#include "sim/model/cloth_model.hpp"

namespace drape::app {

/// Prints warnings to standard error when the solver, or the ghost's, does not suit this cloth.
void printSolverWarnings(const settings::Settings& settings, const sim::ClothModel& model);

}  // namespace drape::app
