#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_model.hpp"

namespace drape::sim {

/// The stiffness and the damping that act on a cloth: those of the parameters if it consists of springs. A fabric has
/// its own moduli and no damping, whatever the parameters say. The rates of its model (unitFrequency, LocalRates) are
/// already its own, so a factor of 1 N/m gives them.
[[nodiscard]] MaterialParameters actingMaterial(const ClothModel& model, const CommonParameters& parameters);

/// The largest local angular frequency omega of a cloth [1/s]: omega_i^2 = 2 lambda_max(sum_j k d d^T) / m_i at the
/// vertex where that is largest, in the rest shape, or that of the fabric (unitFrequencySquared). An upper estimate of
/// the mesh's highest frequency.
[[nodiscard]] double largestFrequency(const ClothModel& model, const CommonParameters& parameters);

/// The longest stable time step of Stoermer-Verlet [s]: 2 / omega without damping; with the damping rate c (explicit,
/// from the velocities at the start of the step) the solution of h^2 omega^2 + 2 h c = 4. Infinite for cloth without
/// stiffness and damping. A fabric has no damping.
[[nodiscard]] double verletStepLimit(const ClothModel& model, const CommonParameters& parameters);

}  // namespace drape::sim
