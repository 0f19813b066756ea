#pragma once

#include "sim/contact/contact_parameters.hpp"
#include "sim/solvers/solver.hpp"

namespace drape::sim {

/// The method of self-collision that acts with a solver: never Auto.
/// @param solver nullptr counts as a solver that does not resolve contacts
[[nodiscard]] inline contact::SelfCollision actingSelfCollision(contact::SelfCollision chosen,
                                                                const SolverInfo* solver) {
  if (chosen != contact::SelfCollision::Auto) {
    return chosen;
  }
  return solver != nullptr && solver->resolvesContacts ? contact::SelfCollision::Exact : contact::SelfCollision::Hash;
}

}  // namespace drape::sim
