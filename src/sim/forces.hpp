#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/step_parameters.hpp"
#include "sim/workers.hpp"

#include <vector>

namespace drape {

/// All the forces on the vertices of a cloth: springs, damping, gravity, air and the hand, gathered spring by spring
/// for each vertex, so that the sums do not depend on the number of threads. Pinned vertices feel them too; what holds
/// them is not part of this.
/// @param force one a vertex [N]; resized
void evaluateForces(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                    const ClothState& state, Workers& workers, std::vector<Vec3>& force);

/// The forces of all springs' elongation k (L - l0) d and damping on one vertex [N].
[[nodiscard]] Vec3 springForcesOn(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                                  std::size_t vertex);

}  // namespace drape
