#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/workers.hpp"

#include <vector>

namespace drape::sim {

/// Predicts positions without springs, damping and attachment: y = x + h v + h^2 a, with gravity and air at the start
/// of the step. Methods that solve for positions start there. Pinned vertices stay.
/// @param predicted one a vertex [m]; resized
void predictPositions(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                      Workers& workers, std::vector<Vec3>& predicted);

/// Ends a step whose positions are solved: v = (x - start) / h. Pinned vertices have zero velocity.
void velocitiesFromPositions(const ClothModel& model, double timeStep, const std::vector<Vec3>& start,
                             ClothState& state);

}  // namespace drape::sim
