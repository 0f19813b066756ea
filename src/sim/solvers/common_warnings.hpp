#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/solvers/solver_warning.hpp"
#include "sim/solvers/step_parameters.hpp"

#include <optional>

namespace drape::sim {

/// The warning for substeps longer than `limit` [s]; none if they are not.
[[nodiscard]] std::optional<SolverWarning> stepLimitWarning(const StepParameters& parameters, double limit);

/// The warning for methods that use the spring constant as the whole derivative and do not iterate: folding then meets
/// the resistance of stretching. Given where (h omega)^2 of a substep exceeds 0.1. The error is then about 20 times
/// that of the exactly solved step (docs/experiments/2026-11-22-solver-comparison.md).
[[nodiscard]] std::optional<SolverWarning> stiffFoldsWarning(const ClothModel& model, const StepParameters& parameters);

/// The warning for iterative methods with too few iterations, which make cloth softer than specified: given where
/// (h omega)^2 of a substep exceeds `perIteration` times the iterations. Each method has its own value
/// (docs/experiments/2026-11-22-solver-comparison.md). None if there are enough iterations.
[[nodiscard]] std::optional<SolverWarning> slackWarning(const ClothModel& model, const StepParameters& parameters,
                                                        double perIteration);

}  // namespace drape::sim
