#pragma once

#include "sim/cloth_model.hpp"
#include "sim/step_parameters.hpp"

namespace drape {

/// How far the cloth's own weight stretches the springs that carry most of it, at rest, as a share of their length [-].
/// An estimate: the weight of all that hangs farther from the pins than some distance, measured along the springs, is
/// carried by the springs that cross that distance; the largest such strain over the distances counts. It takes springs
/// to pull along their rest direction. 0 for cloth without pins, infinite for cloth without stiffness.
[[nodiscard]] double strainByWeight(const ClothModel& model, const StepParameters& parameters);

}  // namespace drape
