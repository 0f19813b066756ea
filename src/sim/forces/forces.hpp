#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

namespace drape::sim {

/// The internal force on one vertex [N]: the elastic forces k (L - l0) d and the damping forces of its springs, or the
/// elastic force of its fabric.
[[nodiscard]] Vec3 internalForceOn(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                                   std::size_t vertex);

/// The stiffness of a cloth against stretch, for estimates [N/m]: that of the springs, or the smaller stretch modulus
/// of a fabric without its stiffening. A mesh of springs of stiffness k has moduli of about k.
[[nodiscard]] double stretchStiffness(const ClothModel& model, const CommonParameters& parameters);

}  // namespace drape::sim
