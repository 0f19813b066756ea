#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/step_parameters.hpp"

namespace drape {

/// The elastic forces k (L - l0) d and the damping forces of all springs on one vertex [N].
[[nodiscard]] Vec3 springForcesOn(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                                  std::size_t vertex);

}  // namespace drape
