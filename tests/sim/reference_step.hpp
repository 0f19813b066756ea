#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/solvers/step_parameters.hpp"

namespace drape::sim::testing {

/// The paper's step written down a second time, from the equations alone and with dense matrices: 3n x 3n mass,
/// stiffness and damping in every variant of the force derivative, block-diagonal part, `sweeps` Jacobi sweeps damped
/// by `relaxation`. It is slow and simple, the reference for the fast one.
void referenceStep(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                   ClothState& state);

/// How the attachment's force counts in the matrix.
enum class AttachmentDerivative {
  Lumped,  ///< the chord's stiffness, on the diagonal
  Whole    ///< the derivative, which couples the corners of the attachment's triangle
};

/// The same linear system, solved by elimination.
void exactLinearStep(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                     AttachmentDerivative attachment, ClothState& state);

}  // namespace drape::sim::testing
