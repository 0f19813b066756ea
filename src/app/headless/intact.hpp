#pragma once

#include "session/simulation.hpp"

namespace drape::app {

/// Throws InputError when the cloth blew up, so that the exit status reports it. Call it after all output is written.
void requireIntact(const session::Simulation& simulation);

}  // namespace drape::app
