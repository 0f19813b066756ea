#pragma once

#include "sim/cloth_model.hpp"
#include "sim/step_parameters.hpp"

#include <cstddef>
#include <string>

namespace drape {

/// omega_i^2 / k of one vertex in the rest shape: 2 lambda_max(sum_j d d^T) / m_i [1/kg], as if it were not pinned.
[[nodiscard]] double unitFrequencySquared(const ClothModel& model, std::size_t vertex);

/// The largest local angular frequency omega of a cloth [1/s]: omega_i^2 = 2 lambda_max(sum_j k d d^T) / m_i at the
/// vertex where that is largest, in the rest shape. An upper estimate of the mesh's highest frequency.
[[nodiscard]] double largestFrequency(const ClothModel& model, const StepParameters& parameters);

/// The longest time step [s] with which Stoermer-Verlet stays stable: 2 / omega without damping; with the damping rate
/// c (explicit, a step late) where h^2 omega^2 + 2 h c = 4. Infinite for cloth without stiffness and damping.
[[nodiscard]] double verletStepLimit(const ClothModel& model, const StepParameters& parameters);

/// A short time in words: "1/240 s". The denominator is rounded up, to three digits, so that a step that is set to what
/// is read here is not above it.
[[nodiscard]] std::string stepInWords(double seconds);

/// What to tell a user whose substeps are longer than `limit` [s], with what helps; empty when they are not.
[[nodiscard]] std::string stepLimitWarning(const StepParameters& parameters, double limit);

/// What to tell a user of a method that takes the spring constant for the whole derivative and is not iterated: folding
/// then meets the resistance of stretching. On sheets of 17 x 17 vertices with 10 N/m, after 7/15 s, kang and desbrun
/// are 20 times as far from the converged motion as the exactly solved step at (h omega)^2 = 0.6 and 0.006 alike, 94
/// and 57 mm at the one, 11 mm at the other; told above 0.1, where it is about 30 mm.
[[nodiscard]] std::string stiffFoldsWarning(const ClothModel& model, const StepParameters& parameters);

/// What to tell a user whose cloth is softer than asked for because a method that passes on tension from spring to
/// spring has too few iterations: when (h omega)^2 of a substep exceeds `reach` times the iterations. The methods say
/// which reach they were measured to have; empty when there are enough.
[[nodiscard]] std::string slackWarning(const ClothModel& model, const StepParameters& parameters, double reach);

}  // namespace drape
