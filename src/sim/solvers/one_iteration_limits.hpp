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
/// falling sheet accelerates with its mass, but is stopped with the inertia h^2 k. Tension travels one spring in a
/// step, so the farthest vertex falls for the time n h, by about (n h)^2 g / L of the side. Measured on the scene of
/// the paper in 190 cases: 9 to 65 vertices a side, 10 to 1e5 N/m, steps of 1/30 to 1/1500 s, 1 and 3 sweeps. The
/// largest energy in 2 s [J], of cloth that starts with 0 J and weighs 1 N:
///
/// | q          | energy                     |
/// |------------|----------------------------|
/// | below 1e3  | at most 10, in one case 19 |
/// | 1e3 to 1e4 | at most 56                 |
/// | 1e4 to 5e4 | 8 to 770                   |
/// | 5e4 to 2e5 | 70 to 3e5                  |
/// | above 2e5  | 600 to 1e16                |
///
/// Meshes with an uneven rest shape gain far less energy; for them the number is too pessimistic.
[[nodiscard]] double energyGainNumber(const ClothModel& model, const StepParameters& parameters);

/// The warning of the one-iteration method, if there is one. In this order:
/// - With derivatives other than `stabilised` and `scalar` cloth blows up if (h omega)^2 of a substep exceeds about 25
///   times the sweeps. On sheets of 9, 17 and 33 vertices a side all cases up to 24 were stable, and none above 300.
/// - Energy gain: q above 1e4.
/// - Slack cloth: (h omega)^2 above the number of sweeps. The position error is then about five times that of the exact
///   linear solve; at a tenth of it both are equal. (17 and 33 vertices a side, 10 to 1000 N/m, 1 to 21 sweeps, after
///   7/15 s.)
[[nodiscard]] std::optional<SolverWarning> oneIterationWarning(const ClothModel& model,
                                                               const StepParameters& parameters);

}  // namespace drape::sim::solvers
