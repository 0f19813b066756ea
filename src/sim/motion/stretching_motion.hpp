#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

namespace drape::sim {

/// Removes kinetic energy from the rates at which the edges of a cloth change their lengths. Each edge gets an impulse
/// along itself, so linear and angular momentum of free pieces do not change, and neither do swinging, folding and
/// rotation. Short waves lose most, since their edges change fastest. Pinned vertices keep their velocities.
/// @param energy kinetic energy to remove [J]
/// @param sweeps the maximum number of sweeps over all edges; in each a short wave loses up to all of its energy [-]
/// @return the kinetic energy removed, at most `energy` [J]
double removeStretchingMotion(const ClothModel& model, double energy, int sweeps, ClothState& state);

}  // namespace drape::sim
