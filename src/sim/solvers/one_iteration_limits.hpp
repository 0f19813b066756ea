#pragma once

#include "sim/cloth_model.hpp"
#include "sim/step_parameters.hpp"

#include <string>

namespace drape::solvers {

/// How much energy the one-iteration step may make from nothing on a flat cloth, as a number without unit:
///
///     q = (h omega)^2 (n h)^2 (g / L) / sweeps
///
/// with the vertices n from side to side and the size L of a square cloth of as many vertices and that area. A falling
/// sheet gains speed with its mass, but must be stopped with inertia h^2 k, and tension travels a spring a step: n h is
/// what the farthest vertex waits for it, and (n h)^2 g / L how far it falls meanwhile. Measured on the scene of the
/// paper, 190 cases of 9 to 65 vertices a side, 10 to 1e5 N/m, steps of 1/30 to 1/1500 s, 1 and 3 sweeps: the most
/// energy seen in 2 s [J], of cloth that begins with none and weighs 1 N, is
///
/// | q          | energy                     |
/// |------------|----------------------------|
/// | below 1e3  | at most 10, in one case 19 |
/// | 1e3 to 1e4 | at most 56                 |
/// | 1e4 to 5e4 | 8 to 770                   |
/// | 5e4 to 2e5 | 70 to 3e5                  |
/// | above 2e5  | 600 to 1e16                |
///
/// Meshes whose rest shape is uneven gain far less; for them the number is too careful.
[[nodiscard]] double energyGainNumber(const ClothModel& model, const StepParameters& parameters);

/// What to tell the user of the one-iteration method; empty when nothing is wrong. In this order:
/// - With derivatives other than `stabilised` and `scalar` the cloth blows up where (h omega)^2 of a substep exceeds
///   about 25 times the sweeps: on sheets of 9, 17 and 33 vertices a side all was calm up to 24 and nothing above 300.
/// - It may gain energy from nothing: q above 1e4.
/// - It is slack: (h omega)^2 above the number of sweeps. There the positions are about five times as far from the
///   converged motion as those of the exact linear solve; at a tenth of it they are as near. (17 and 33 vertices a
///   side, 10 to 1000 N/m, 1 to 21 sweeps, after 7/15 s.)
[[nodiscard]] std::string oneIterationWarning(const ClothModel& model, const StepParameters& parameters);

}  // namespace drape::solvers
