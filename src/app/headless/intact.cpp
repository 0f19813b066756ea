#include "app/headless/intact.hpp"

#include "messages/blow_up_text.hpp"
#include "messages/error.hpp"

#include <string>

namespace drape::app {

void requireIntact(const session::Simulation& simulation) {
  if (simulation.blewUp()) {
    throw messages::InputError("the cloth blew up at " + std::to_string(simulation.state().time) +
                               " s; the output ends there. " + messages::remedyForBlowUp(simulation.model()));
  }
}

}  // namespace drape::app
