#pragma once

#include "session/simulation.hpp"

namespace drape {

/// Throws InputError when the cloth blew up, so that a script learns of it from the exit status. Call it when all that
/// was asked for has been written.
void requireIntact(const Simulation& simulation);

}  // namespace drape
