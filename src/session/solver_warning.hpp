#pragma once

#include "settings/settings.hpp"
#include "sim/model/cloth_model.hpp"
#include "text/sentence.hpp"

namespace drape::session {

/// A warning in words when the chosen solver does not suit this cloth; empty otherwise.
[[nodiscard]] text::Sentence solverWarning(const settings::Settings& settings, const sim::ClothModel& model);

/// The same for the ghost; empty without a ghost.
[[nodiscard]] text::Sentence ghostWarning(const settings::Settings& settings, const sim::ClothModel& model);

/// Throws InputError if the cloth is a fabric and the solver, or that of the ghost, takes springs only.
void requireSolversForMaterial(const settings::Settings& settings);

}  // namespace drape::session
