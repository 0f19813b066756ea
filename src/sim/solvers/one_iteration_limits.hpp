#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/solvers/solver_warning.hpp"
#include "sim/solvers/step_parameters.hpp"

#include <optional>

namespace drape::sim::solvers {

/// A dimensionless number for the energy gain of the one-iteration step on flat cloth:
///
///     q = (h omega)^2 (n h)^2 (g / L) / sweeps
///
/// n is the number of vertices along a side and L the side of a square cloth with as many vertices and the same area. A
/// falling sheet accelerates according to its mass, but springs stop it with the inertia h^2 k. Tension travels one
/// spring in a step, so the farthest vertex falls for the time n h, by about (n h)^2 g / L of the side. The record
/// docs/experiments/2026-11-22-solver-comparison.md has the energies for a range of q. Meshes with an uneven rest shape
/// gain far less energy; for them the number is too large.
[[nodiscard]] double energyGainNumber(const ClothModel& model, const StepParameters& parameters);

/// The warning of the one-iteration method, if there is one. In this order, with the limits of
/// docs/experiments/2026-11-22-solver-comparison.md:
/// - Indefinite matrix: a derivative other than `stabilised` and `scalar`, and (h omega)^2 of a substep above 25 times
///   the sweeps. Cloth can then blow up.
/// - Energy gain: q above 1e4.
/// - Slack cloth: (h omega)^2 above the number of sweeps. The position error is then about five times that of the exact
///   linear solve.
[[nodiscard]] std::optional<SolverWarning> oneIterationWarning(const ClothModel& model,
                                                               const StepParameters& parameters);

}  // namespace drape::sim::solvers
