#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/forces/kernels.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

#include <cstddef>

namespace drape::sim {

/// Whether the air acts on this cloth as on a thin plate (kernels::plateForce).
[[nodiscard]] bool actsAsPlate(const ClothModel& model, const AirParameters& air);

/// @param area of the vertex [m^2]
[[nodiscard]] kernels::AirFactors airFactorsOf(const AirParameters& air, double area);

/// Gravity and air on a vertex [N]. Every method evaluates the air at the start of a step.
[[nodiscard]] Vec3 gravityAndAir(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                                 std::size_t vertex);

}  // namespace drape::sim
