#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/step_parameters.hpp"

namespace drape {

/// How well a step from `before` to `after` satisfies what backward Euler asks of it, over free vertices. Both take the
/// step as one of `parameters.timeStep`, whatever parts it was taken in; for a method that does not solve backward
/// Euler they tell how far it is from it, not how good it is. 0 when both sides vanish.

/// |M (v1 - v0) - h f(x1, v1)| / |h f(x0 + h v0, v0)|: the residual of the equations themselves [-], related to that of
/// coasting on with the old velocity. Springs, damping and the hand stand at the end of the step; gravity and air at
/// its start, as everywhere (docs/theory/method.md).
[[nodiscard]] double nonlinearResidual(const ClothModel& model, const StepParameters& parameters,
                                       const StepInputs& inputs, const ClothState& before, const ClothState& after);

}  // namespace drape
