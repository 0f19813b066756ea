#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/forces/step_inputs.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

namespace drape::sim {

/// Relative residuals of the backward-Euler equations for a step from `before` to `after`, over free vertices. Both
/// treat the step as one of `parameters.timeStep`, without regard to substeps. For a method that does not solve
/// backward Euler they tell the distance from backward Euler, not the quality. 0 if both numerator and denominator
/// vanish.

/// |M (v1 - v0) - h f(x1, v1)| / |h f(x0 + h v0, v0)|: the residual of the nonlinear equations, relative to that of a
/// step with constant velocity [-]. Springs, damping and attachment count at the end of the step, gravity and air at
/// its start (docs/theory/method.md).
[[nodiscard]] double nonlinearResidual(const ClothModel& model, const CommonParameters& parameters,
                                       const StepInputs& inputs, const ClothState& before, const ClothState& after);

}  // namespace drape::sim
