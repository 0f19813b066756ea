#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/step_parameters.hpp"

namespace drape::testing {

/// The paper's step written down a second time, from the equations alone and with dense matrices: 3n x 3n mass,
/// stiffness and damping, block-diagonal part, `sweeps` Jacobi sweeps. Slow and plain: it is the judge of the fast one.
void referenceStep(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                   ClothState& state);

}  // namespace drape::testing
