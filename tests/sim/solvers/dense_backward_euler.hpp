#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/solvers/step_parameters.hpp"

namespace drape::sim::testing {

/// A backward-Euler step whose nonlinear equations M (x - y) = h^2 f(x) - h C_d L (x - x_n) are solved to rounding by
/// Newton's method with dense matrices and exact derivatives; y = x_n + h v_n + h^2 g. Springs, damping, gravity, pins
/// and attachment (while its force is below its bound); no air. Throws if Newton does not converge.
void denseBackwardEulerStep(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                            ClothState& state);

}  // namespace drape::sim::testing
