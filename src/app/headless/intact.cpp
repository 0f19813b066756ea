#include "app/headless/intact.hpp"

#include "messages/error.hpp"

#include <string>

namespace drape {

void requireIntact(const Simulation& simulation) {
  if (simulation.blewUp()) {
    throw InputError("the cloth blew up at " + std::to_string(simulation.state().time) +
                     " s; the output ends there. Use a smaller time step or a lower stiffness.");
  }
}

}  // namespace drape
