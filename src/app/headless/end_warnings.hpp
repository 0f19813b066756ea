#pragma once

#include "session/simulation.hpp"

namespace drape::app {

/// Prints warnings about the last state to standard error: the simulation's message, seams that are open, overstretched
/// cloth, and cloth that intersects itself. Prints no message of a cloth that blew up, which is an error.
void printEndWarnings(const session::Simulation& simulation);

}  // namespace drape::app
