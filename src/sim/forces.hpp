#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/step_parameters.hpp"
#include "sim/workers.hpp"

#include <vector>

namespace drape {

/// All forces on the vertices of a cloth: springs, damping, gravity, air and attachment. Each vertex sums over its
/// springs, so the result does not depend on the number of threads. Pinned vertices get forces too, without the
/// reaction force.
/// @param force one a vertex [N]; resized
void evaluateForces(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                    const ClothState& state, Workers& workers, std::vector<Vec3>& force);

/// The elastic forces k (L - l0) d and the damping forces of all springs on one vertex [N].
[[nodiscard]] Vec3 springForcesOn(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                                  std::size_t vertex);

}  // namespace drape
