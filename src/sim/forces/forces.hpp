#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

namespace drape::sim {

/// The elastic forces k (L - l0) d and the damping forces of all springs on one vertex [N].
[[nodiscard]] Vec3 springForcesOn(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                                  std::size_t vertex);

}  // namespace drape::sim
