#pragma once

#include "session/simulation.hpp"

namespace drape {

/// Throws InputError when the cloth blew up, so that the exit status reports it. Call it after all output is written.
void requireIntact(const Simulation& simulation);

}  // namespace drape
