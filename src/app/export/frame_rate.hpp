#pragma once

#include "settings/settings.hpp"

#include <functional>
#include <span>
#include <string>

namespace drape::app {

/// Frames per second when the user gives none.
inline constexpr double usualFrameRate = 30.0;
inline constexpr double minFrameRate = 0.1;
inline constexpr double maxFrameRate = 1000.0;

/// The longest time step [s] up to `timeStep` of which a frame is a whole number.
[[nodiscard]] double fittingTimeStep(double rate, double timeStep);

/// Shortens the time step of a scene so that a frame is a whole number of steps, with a note on standard error. Does
/// nothing if it is one already, or if one of the changes ("key=value") sets the time step.
[[nodiscard]] std::function<void(settings::Settings&)> fitTimeStep(double rate, std::span<const std::string> changes);

/// The number of time steps in a frame. Throws UsageError, with a time step that fits, when that is not a whole number.
[[nodiscard]] int stepsPerFrame(double rate, double timeStep);

}  // namespace drape::app
