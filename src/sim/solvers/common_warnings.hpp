#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/solvers/solver_warning.hpp"
#include "sim/solvers/step_parameters.hpp"

#include <optional>

namespace drape::sim {

/// The warning for substeps longer than `limit` [s]; empty if they are not longer.
[[nodiscard]] std::optional<SolverWarning> stepLimitWarning(const StepParameters& parameters, double limit);

/// The warning for methods that do not iterate and take the stiffness k in all directions as the derivative of a
/// spring: cloth then resists folding as much as stretching. It is given if (h omega)^2 of a substep exceeds 0.1. The
/// error is then about 20 times that of the exactly solved step (docs/experiments/2026-11-22-solver-comparison.md).
[[nodiscard]] std::optional<SolverWarning> stiffFoldsWarning(const ClothModel& model, const StepParameters& parameters);

/// The warning for iterative methods with too few iterations, which make cloth softer than specified. It is given if
/// (h omega)^2 of a substep exceeds `perIteration` times the number of iterations. Each method has its own value
/// (docs/experiments/2026-11-22-solver-comparison.md). Empty if there are enough iterations.
[[nodiscard]] std::optional<SolverWarning> slackWarning(const ClothModel& model, const StepParameters& parameters,
                                                        double perIteration);

}  // namespace drape::sim
